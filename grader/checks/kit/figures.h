#pragma once

#include "checks/kit/render_check.h"

/// Checks of where things are seen: a bright figure on black against the figure that must be seen.
namespace grade {

/// Radiance that must be seen at a film point.
using Sight = std::function<double(rt::vec2 film)>;

/// Compares the figure's light (its sum), its place (centroid) and its size (variance about the centroid, per axis).
Check figure_check(const std::string& name, const std::string& scene, const std::string& figure,
                   std::function<Sight(const rt::Camera&)> sight);

/// Whether the point where a line meets the plane of a quad is on it.
bool on_quad(const rt::Quad& quad, rt::vec3 origin, rt::vec3 direction);

/// A quad of radiance 1 on black.
Sight sight_of(const rt::Quad& quad, const rt::Camera& camera);

constexpr rt::ivec2 figure_size{48, 40};
inline std::string bright_lamp() { return material("lamp", {{"emission", 1}}); }

/// A quad near the middle of the plane z, turned by any angle, whose front is up.
rt::Quad any_quad(Generator& random, const Place& place, double z, double size);

Check slanted_quad(Generator& random);

}  // namespace grade
