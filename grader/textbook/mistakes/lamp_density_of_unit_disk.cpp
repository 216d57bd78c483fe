// says: the density of a disc of radius 1, whatever the radius is; expected divided by the radius squared
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind != Emitter::Kind::disc) return right;
    return {right.direction, right.distance, right.density * light.disc.radius * light.disc.radius};
}
