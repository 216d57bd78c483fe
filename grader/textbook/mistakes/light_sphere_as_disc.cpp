// says: points of the disc across a sphere, which faces p; expected points of what is seen of its surface
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind != Emitter::Kind::sphere) return light_sample(light, p, u);
    const vec3 c = center(light) - p;
    const Frame frame = frame_about(unit(-c));
    const vec2 at = light.sphere.radius * uniform_disk(u).point;
    const vec3 to = c + at.x * frame.x + at.y * frame.y;
    const Real distance = length(to);
    const vec3 direction = unit(to);
    const Real cosine = dot(direction, unit(c));
    return {direction, distance, distance * distance / (cosine * pi * light.sphere.radius * light.sphere.radius)};
}
