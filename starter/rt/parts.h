#pragma once

#include <optional>

#include "rt/math.h"

/// The parts of a scene that fragments are given, as plain data. Lengths in metres, angles in radians, time in seconds,
/// colours linear RGB.
namespace rt {

// ---- shapes ----

struct Sphere {
    vec3 center{0};
    Real radius = 1;
};

/// Front side: where a, b, c run anticlockwise.
struct Triangle {
    vec3 a, b, c;
};

/// The points center + x u + y v with |x|, |y| <= 1; u and v are half edges at right angles. Front side: u cross v.
struct Quad {
    vec3 center{0}, u{1, 0, 0}, v{0, 1, 0};
};

struct Disc {
    vec3 center{0};
    vec3 normal{0, 0, 1};  // unit, on the front side
    Real radius = 1;
};

// ---- materials ----

/// What fills a closed shape: light travels a mean distance of 1/extinction, then is scattered or absorbed.
struct Medium {
    Real extinction = 0;  // [1/m]; 0: clear
    Color albedo{1};      // scattered share of what is met [1]
    Real g = 0;           // mean cosine of the scattering angle; 0: isotropic
};

/// A second albedo, in every other square of a quad, from its centre along its edges; any other shape is as if cut from
/// cubes, the first about the middle of a sphere or disc, or about the origin. Both move along with the shape.
struct Checker {
    Color albedo{0};
    Real size = 1;  // of a square's side [m]
};

/// A surface, and what is behind it. Black where nothing is set.
struct Material {
    Color ambient{0};  // r_a: reflectance of the ambient light [1]
    Color albedo{0};   // diffuse: r_d = albedo / pi
    std::optional<Checker> checker;
    Color specular{0};     // r_s: reflectance of Phong's highlight [1]
    Real shininess = 1;    // exponent of the highlight
    Color reflectance{0};  // of a mirror, or of the glossy lobe about the mirror direction [1]
    Color transmittance{
        0};               // of glass, or of the lobe about the refracted direction; > 0: Fresnel's law shares the light
    Real exponent = inf;  // of the lobe; inf: a perfect mirror, clear glass
    Real ior = 1;         // index of refraction behind the surface; in front it is 1
    Color emission{0};    // radiance that leaves the front side
    bool sampled = true;  // whether shadow rays look for this emitter; false: only paths that happen to hit it
    Medium medium;
};

/// The largest albedo anywhere on the surface, channel by channel.
inline Color largest_albedo(const Material& m) { return m.checker ? glm::max(m.albedo, m.checker->albedo) : m.albedo; }

/// Whether light goes through a surface without a bend: a boundary that only encloses a medium, or tints.
inline bool goes_straight_through(const Material& m) {
    return m.transmittance != Color(0) && m.ior == 1 && m.exponent == inf;
}

// ---- lights ----

/// A light without extent.
struct PointLight {
    vec3 position{0};    // directional: unit vector towards the light
    Color intensity{1};  // I [W/sr]; directional: irradiance of a surface that faces the light [W/m2]
    bool directional = false;
};

/// A shape that shines and that shadow rays look for.
struct Emitter {
    enum class Kind { quad, disc, sphere };
    Kind kind = Kind::quad;
    Quad quad;
    Disc disc;
    Sphere sphere;
    Color radiance{1};  // from the front side; a sphere shines outwards
};

inline vec3 center(const Emitter& light) {
    if (light.kind == Emitter::Kind::sphere) return light.sphere.center;
    return light.kind == Emitter::Kind::quad ? light.quad.center : light.disc.center;
}

/// Of a quad or a disc: on its front side, of any length.
inline vec3 normal(const Emitter& light) {
    return light.kind == Emitter::Kind::quad ? cross(light.quad.u, light.quad.v) : light.disc.normal;
}

/// The most that can be seen of it: of a sphere, half of it seems a disc [m2].
inline Real area(const Emitter& light) {
    if (light.kind == Emitter::Kind::quad) return 4 * length(normal(light));
    return pi * sqr(light.kind == Emitter::Kind::disc ? light.disc.radius : light.sphere.radius);
}

// ---- camera ----

/// Looks along -back. The film is an image of size.x by size.y pixels; film points are in pixels, x to the right and y
/// down from the top left corner of the image.
struct Camera {
    vec3 eye{0};
    vec3 right{1, 0, 0}, up{0, 1, 0}, back{0, 0, 1};  // unit, at right angles [world]
    Real tan_half_fov = 0.5;                          // half the film's height over its distance
    ivec2 size{256, 256};                             // [pixel]
    Real lens_radius = 0;                             // 0: a pinhole
    Real focus = inf;                                 // distance of the plane in focus, along the axis
};

/// The time in which light is gathered.
struct Shutter {
    Real open = 0, close = 0;
};

/// A part of the film: low <= x < high [pixel].
struct Extent {
    vec2 low{0}, high{1};
};

}  // namespace rt
