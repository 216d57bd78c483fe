// says: the length of a sphere's tangent, sqrt(d^2 - r^2), as the distance; expected that along the direction
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind != Emitter::Kind::sphere) return right;
    const vec3 c = light.sphere.center - p;
    return {right.direction, safe_sqrt(dot(c, c) - light.sphere.radius * light.sphere.radius), right.density};
}
