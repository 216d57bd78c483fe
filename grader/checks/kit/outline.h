#pragma once

#include "checks/kit/check.h"
#include "checks/kit/render_check.h"

/// Checks of where things are seen: a bright figure on black against the figure that must be seen.
namespace grade {

/// Radiance that must be seen at a film point.
using Sight = std::function<double(rt::vec2 film)>;

/// Compares the figure's light (its sum), its place (centroid) and its size (variance about the centroid, per axis).
std::vector<Statistic> figure_statistics(const rt::Camera& camera, const Sight& sight, const std::string& figure);

Check figure_check(const std::string& name, const std::string& scene, const std::string& figure,
                   std::function<Sight(const rt::Camera&)> sight);

/// Whether the point where a line meets the plane of a quad is on it.
bool on_quad(const rt::Quad& quad, rt::vec3 origin, rt::vec3 direction);

}  // namespace grade
