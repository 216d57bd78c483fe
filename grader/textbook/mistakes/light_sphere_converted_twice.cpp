// says: the density of sphere_cone, per solid angle already, times distance^2 / cosine; expected that density itself
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind != Emitter::Kind::sphere || right.density <= 0) return right;
    const vec3 outward = unit(p + right.distance * right.direction - light.sphere.center);
    const Real cosine = -dot(right.direction, outward);
    const Real squared = right.distance * right.distance;
    return {right.direction, right.distance, cosine > 0 ? right.density * squared / cosine : 0.0};
}
