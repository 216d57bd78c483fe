// says: the distance to the centre of a sphere, not to its surface
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind != Emitter::Kind::sphere) return right;
    return {right.direction, glm::length(light.sphere.center - p), right.density};
}
