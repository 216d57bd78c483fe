// says: the distance to a sphere's nearest point, whatever the direction; expected that along the direction
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind != Emitter::Kind::sphere) return right;
    return {right.direction, length(light.sphere.center - p) - light.sphere.radius, right.density};
}
