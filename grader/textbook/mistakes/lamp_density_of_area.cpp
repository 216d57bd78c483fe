// says: the density per area, 1 / area, as it is; expected that per solid angle: times distance^2 / cosine
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind == Emitter::Kind::sphere || right.density <= 0) return right;
    return {right.direction, right.distance, 1 / area(light)};
}
