#pragma once

#include "checks/kit/scene.h"

/// Figures of light laid out in pixels.
namespace grade {

constexpr double film_pixel = 0.01;  // [m] of the plane that such a camera sees

/// A camera that sees the plane z = 0 of a place in pixels.
View film_view(const Place& place, rt::ivec2 size);

/// A rectangle of light on the film, by its centre and half edges in pixels, y down.
std::string bright(const Place& place, rt::ivec2 size, const std::string& material, rt::vec2 center, rt::vec2 u,
                   rt::vec2 v);

}  // namespace grade
