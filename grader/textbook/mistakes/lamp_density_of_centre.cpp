// says: distance and cosine of the lamp's centre in the density; expected those of the sampled point
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind == Emitter::Kind::sphere) return right;
    const vec3 to_center = center(light) - p;
    const Real distance = length(to_center);
    const Real cosine = -dot(to_center, unit(normal(light))) / distance;
    return {right.direction, right.distance, right.density > 0 ? distance * distance / (cosine * area(light)) : 0};
}
