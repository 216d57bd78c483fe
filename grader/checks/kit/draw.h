#pragma once

#include "checks/kit/check.h"
#include "files/stamp.h"
#include "rt/math.h"
#include "rt/scene.h"

/// Parameters and arguments drawn at random.
namespace grade {

inline double between(Generator& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline bool chance(Generator& random, double probability) { return between(random, 0, 1) < probability; }

/// Uniform in the logarithm.
inline double log_between(Generator& random, double low, double high) {
    return std::exp(between(random, std::log(low), std::log(high)));
}

/// Likewise, and often one of the two ends: what is promised is promised there too.
inline double range_between(Generator& random, double low, double high) {
    if (chance(random, 0.2)) return chance(random, 0.5) ? low : high;
    return log_between(random, low, high);
}

/// Of either sign, uniform in the logarithm of its size, from `closest` to a twentieth.
inline double close_to_zero(Generator& random, double closest) {
    const double sign = between(random, 0, 1) < 0.5 ? -1 : 1;
    return sign * log_between(random, closest, 0.05);
}

inline int whole_between(Generator& random, int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random);
}

/// A point of the unit square.
inline rt::vec2 square(Generator& random) {
    const double x = between(random, 0, 1), y = between(random, 0, 1);
    return {x, y};
}

/// Each coordinate between low and high.
inline rt::vec3 box(Generator& random, double low, double high) {
    const double x = between(random, low, high), y = between(random, low, high), z = between(random, low, high);
    return {x, y, z};
}

/// A unit vector, uniform on the sphere.
inline rt::vec3 direction(Generator& random) {
    const double z = between(random, -1, 1), turn = between(random, 0, 2 * rt::pi), r = rt::safe_sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Along an axis of the world, as in most scenes that people make.
inline rt::vec3 exact_direction(Generator& random) {
    rt::vec3 d(0);
    d[whole_between(random, 0, 2)] = chance(random, 0.5) ? 1 : -1;
    return d;
}

/// A unit vector that is nearly an axis of the world.
inline rt::vec3 near_axis(Generator& random) {
    const rt::vec3 off = log_between(random, 1e-3, 0.1) * direction(random);
    return rt::unit(exact_direction(random) + off);
}

/// A unit vector as scenes have them: along an axis of the world or nearly so, level or upright, or any.
inline rt::vec3 scene_direction(Generator& random) {
    if (chance(random, 0.3)) return exact_direction(random);
    if (chance(random, 0.15)) return near_axis(random);
    if (!chance(random, 0.15)) return direction(random);
    const double turn = between(random, 0, 2 * rt::pi);
    const int axis = whole_between(random, 0, 2);
    rt::vec3 d(0);
    d[(axis + 1) % 3] = std::cos(turn), d[(axis + 2) % 3] = std::sin(turn);
    return d;
}

/// An angle up to `most`: of 0 as well.
inline double angle_from_axis(Generator& random, double most) {
    return chance(random, 0.12) ? 0 : between(random, 0, most);
}

/// A point on the rim of the unit square: a coordinate of 0, or next to it, or the largest number below 1.
inline rt::vec2 end_of_square(Generator& random) {
    // either end as often as the other: the mean stays 1/2, but not the second moment
    const auto end = [&] { return chance(random, 0.5) ? 1 - 0x1p-53 : chance(random, 0.5) ? 0 : 0x1p-53; };
    const double x = end(), y = chance(random, 0.02) ? end() : between(random, 0, 1);
    return chance(random, 0.5) ? rt::vec2(x, y) : rt::vec2(y, x);
}

/// Its rim, or halfway, where maps of the square have a seam.
inline rt::vec2 seam_of_square(Generator& random) {
    if (chance(random, 0.9)) return end_of_square(random);
    const double x = between(random, 0, 1);
    return chance(random, 0.5) ? rt::vec2(x, 0.5) : rt::vec2(0.5, x);
}

/// A point of the unit square, now and then on its rim.
inline rt::vec2 square_with_ends(Generator& random) {
    return chance(random, 0.1) ? end_of_square(random) : square(random);
}

/// A unit vector at the given angle from a unit vector.
inline rt::vec3 tilted(Generator& random, rt::vec3 axis, double angle) {
    const double turn = between(random, 0, 2 * rt::pi), s = std::sin(angle);
    return rt::frame_about(axis).to_world({s * std::cos(turn), s * std::sin(turn), std::cos(angle)});
}

/// One list behind the other.
template <class Item>
std::vector<Item> joined(std::vector<Item> list, const std::vector<Item>& more) {
    list.insert(list.end(), more.begin(), more.end());
    return list;
}

/// A colour with some of its channels black, or full: bit c of `which` for channel c.
inline rt::Color with_channels(rt::Color color, unsigned which, double value) {
    for (int c = 0; c < 3; ++c)
        if (which >> c & 1) color[c] = value;
    return color;
}

/// A stream of random numbers of a check's own, so that other checks do not move it.
inline Generator stream(std::uint64_t seed, const std::string& name) {
    return Generator(fnv1a(name, fnv1a("") ^ seed));
}

/// A material all of whose colours count, or none: what a fragment does not ask for may be anything.
inline rt::Material any_material(Generator& random) {
    rt::Material m;
    if (chance(random, 0.5)) return m;
    for (rt::Color* color : {&m.ambient, &m.albedo, &m.specular, &m.reflectance, &m.transmittance, &m.emission})
        *color = box(random, 0.1, 0.9);
    m.exponent = log_between(random, 1, 1e3), m.ior = between(random, 1, 2);
    return m;
}

}  // namespace grade
