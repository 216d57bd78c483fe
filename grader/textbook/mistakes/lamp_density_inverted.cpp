// says: the density per area times cosine / distance^2 in place of distance^2 / cosine
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind == Emitter::Kind::sphere) return light_sample(light, p, u);
    const LightSample right = light_sample(light, p, u);
    const Real cosine = std::max(-dot(right.direction, unit(normal(light))), 0.0);
    return {right.direction, right.distance, cosine / (right.distance * right.distance * area(light))};
}
