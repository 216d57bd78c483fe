// says: numbers from 0 to 1 before the half edges of a quad, a quarter of it; they reach from -1 to 1
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind != Emitter::Kind::quad) return light_sample(light, p, u);
    const vec3 to_point = light.quad.center + u.x * light.quad.u + u.y * light.quad.v - p;
    const Real distance = glm::length(to_point);
    const vec3 direction = to_point / distance;
    const Real cosine = -dot(direction, unit(normal(light)));
    return {direction, distance, cosine > 0 ? distance * distance / (cosine * area(light)) : 0.0};
}
