#include "checks/light_sample/checks.h"

namespace grade::light_sample {

using rt::Emitter, rt::LightSample, rt::vec2, rt::vec3;

Emitter emitter(Generator& random, Emitter::Kind kind) {
    Emitter light;
    light.kind = kind;
    const rt::Frame frame = rt::frame_about(scene_direction(random));
    light.quad = {box(random, -1, 1), between(random, 0.2, 0.6) * frame.x, between(random, 0.2, 0.6) * frame.y};
    light.disc = {box(random, -1, 1), frame.z, between(random, 0.2, 0.6)};
    light.sphere = {box(random, -1, 1), between(random, 0.3, 0.8)};
    return light;
}

vec2 on_light(const Emitter& light, vec3 p, const LightSample& s) {
    const vec3 q = p + s.distance * s.direction - rt::center(light);
    if (light.kind == Emitter::Kind::quad)
        return {rt::dot(q, light.quad.u) / rt::dot(light.quad.u, light.quad.u),
                rt::dot(q, light.quad.v) / rt::dot(light.quad.v, light.quad.v)};
    const rt::Frame frame = rt::frame_about(light.disc.normal);
    return vec2(rt::dot(q, frame.x), rt::dot(q, frame.y)) / light.disc.radius;
}

double off_light(const LightSample& s, const Emitter& light, vec3 p, vec2) {
    if (!(s.density > 0)) return s.density == 0 ? 0 : rt::inf;
    if (std::abs(glm::length(s.direction) - 1) > 1e-4) return rt::inf;
    const vec3 q = p + s.distance * s.direction - rt::center(light);
    if (light.kind == Emitter::Kind::sphere) {
        const double off = std::abs(glm::length(q) / light.sphere.radius - 1);
        return rt::dot(q, s.direction) > 1e-3 * light.sphere.radius ? rt::inf : off;  // the near side alone is seen
    }
    const vec2 at = on_light(light, p, s);
    const double size = std::sqrt(rt::area(light)),
                 off_plane = std::abs(rt::dot(q, rt::unit(rt::normal(light)))) / size;
    const double beyond =
        light.kind == Emitter::Kind::quad ? std::max(std::abs(at.x), std::abs(at.y)) - 1 : std::hypot(at.x, at.y) - 1;
    return std::max({off_plane, beyond, 0.0});
}

Statistic samples_on_light(const std::string& unit, const std::string& says) {
    return property({.id = "L1",
                     .what = "distance of the samples from the light, in its " + unit,
                     .violation = of_call<rt::light_sample>(off_light),
                     .tolerance = 1e-3,
                     .says = says});
}

std::function<Rows(Generator&)> samples_of(const Emitter& light, vec3 p, int side) {
    return with_repeats(rows_over_square(side, [=](vec2 u) { return row(light, p, u); }));
}

}  // namespace grade::light_sample
