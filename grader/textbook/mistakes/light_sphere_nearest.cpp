// says: the distance to where the ray passes the centre of a sphere, half a chord behind its surface
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind != Emitter::Kind::sphere) return right;
    return {right.direction, dot(light.sphere.center - p, right.direction), right.density};
}
