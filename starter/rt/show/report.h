#pragma once

#include <string>

#include "rt/render.h"

/// What is said of a picture when it is made. Nobody needs this file for the assignment.
namespace rt {

constexpr const char* version = "0.1";

/// Size, samples, error, time, rays and hash, as lines of text.
std::string report(const std::string& name, const RenderSettings& settings, const Rendering& rendering);

/// The same in an EXR file, with the place of the picture in its film.
Label label_of(const std::string& scene, ivec2 film, const RenderSettings& settings, const Rendering& rendering);

/// What a file in single precision cannot hold of a picture; empty: it holds all.
std::string report_range(const std::string& name, const Image& image);

/// The number that is none, and the command which shows how it came about.
std::string report_bad_sample(const std::string& scene, ivec2 film, const RenderSettings& settings,
                              const BadSample& bad);

}  // namespace rt
