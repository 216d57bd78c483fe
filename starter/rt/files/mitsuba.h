#pragma once

#include <string>
#include <vector>

#include "rt/scene.h"

/// Nobody needs this file for the assignment.
namespace rt {

/// A scene for Mitsuba 3: the XML, and beside it the triangles, for which the XML has no words.
struct MitsubaFiles {
    struct File {
        std::string name, contents;
    };
    std::string xml;
    std::vector<File> meshes;
};

/// The scene with the same physics: box filter, linear RGB, for the variants scalar_rgb and llvm_ad_rgb.
///
/// Two things are Mitsuba's own. Radiance that crosses into glass grows there by the square of the index of refraction,
/// which makes a difference only for a lamp inside glass. And the glossy lobe is the plugin "penumbra_lobe", which
/// tests/mitsuba/lobe.py registers.
///
/// stem    what the names of the meshes' files begin with
/// errors  InputError with one line for each thing that Mitsuba has no words for
MitsubaFiles to_mitsuba(const Scene& scene, const std::string& stem);

/// Writes the XML to a path and the meshes beside it. Errors as to_mitsuba; std::runtime_error that names a path which
/// cannot be written.
void export_mitsuba(const Scene& scene, const std::string& path);

}  // namespace rt
