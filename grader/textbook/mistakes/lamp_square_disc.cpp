// says: the square 2 * u - 1 in place of a point of the disc: its corners lie outside
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind != Emitter::Kind::disc) return light_sample(light, p, u);
    const vec2 at = light.disc.radius * (2.0 * u - vec2(1));
    const vec3 point = light.disc.center + frame_about(light.disc.normal).to_world(vec3(at.x, at.y, 0.0));
    const vec3 to_point = point - p;
    const Real distance = glm::length(to_point);
    const vec3 direction = to_point / distance;
    const Real cosine = -dot(direction, unit(normal(light)));
    return {direction, distance, cosine > 0 ? distance * distance / (cosine * area(light)) : 0.0};
}
