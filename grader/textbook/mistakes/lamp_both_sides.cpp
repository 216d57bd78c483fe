// says: abs(cosine) at the lamp, so that its back shines too; expected density 0 there
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const LightSample right = light_sample(light, p, u);
    if (light.kind == Emitter::Kind::sphere) return right;
    const Real cosine = std::abs(dot(right.direction, unit(normal(light))));
    return {right.direction, right.distance,
            cosine > 0 ? right.distance * right.distance / (cosine * area(light)) : 0.0};
}
