// says: the middle half of a quad, center + (u.x - 0.5) * quad.u + ...; expected 2 * u - 1, from edge to edge
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    const vec2 middle = vec2(0.25) + u / 2.0;
    return light.kind == Emitter::Kind::quad ? light_sample(light, p, middle) : light_sample(light, p, u);
}
