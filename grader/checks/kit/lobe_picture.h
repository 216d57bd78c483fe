#pragma once

#include "checks/kit/render_check.h"

/// Pictures of lobes: what a glossy or translucent surface shows of a lamp.
namespace grade {

/// A lobe at one point of a surface; share is what its material and Fresnel's law leave of it.
struct Lobe {
    rt::vec3 axis, outward;  // outward: normal on the side to which the lobe goes
    double exponent, share;
};

/// Light of a ball of radiance 1 that a lobe gathers at p: the integral over the ball's directions of
///
///     share (n + 2)/(2 pi) cos(alpha)^n cos(theta)
double lobe_light(const Lobe& lobe, const rt::Sphere& lamp, rt::vec3 p);

/// A flat lobe surface that fills the picture.
struct LobeSurface {
    rt::Camera camera;
    rt::vec3 point, normal;
    std::function<Lobe(rt::vec3 d, double exponent)> lobe;  // d the direction of view
};

/// What such a surface shows of a lamp: brightness, place and width of its blurred image, against those of the picture
/// that the integrals give. Mistakes in the exponent are known by the width to which they lead.
std::vector<Statistic> blurred_lamp(const LobeSurface& surface, const rt::Sphere& lamp, double exponent,
                                    const std::string& lobe_about);

/// phong_albedo of one exponent, from a table.
std::function<double(double angle)> tabulated_albedo(double exponent);

}  // namespace grade
