LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    vec3 point = center(light);
    vec3 n = vec3(0, 0, 1);
    Real area = 0;
    if (light.kind == Emitter::Kind::sphere) {
        const vec3 w = light.sphere.center - p;
        const Real far = glm::length(w);
        const Real sine2 = light.sphere.radius * light.sphere.radius / (far * far);
        const Real cos_max = safe_sqrt(1 - sine2);
        const Real c = 1 - u.x * (1 - cos_max);
        const Real s = safe_sqrt(1 - c * c);
        const Real phi = 2 * pi * u.y;
        const vec3 local = vec3(s * std::cos(phi), s * std::sin(phi), c);
        const vec3 direction = frame_about(w / far).to_world(local);
        const Real half = safe_sqrt(light.sphere.radius * light.sphere.radius - far * far * s * s);
        const Real density = sine2 < 1 ? 1 / (2 * pi * (1 - cos_max)) : 0.0;
        return {direction, far * c - half, density};
    }
    if (light.kind == Emitter::Kind::quad) {
        point = light.quad.center + (2 * u.x - 1) * light.quad.u + (2 * u.y - 1) * light.quad.v;
        n = cross(light.quad.u, light.quad.v);
        area = 4 * glm::length(n);
    } else {
        const Real r = light.disc.radius * std::sqrt(u.x);
        const Real phi = 2 * pi * u.y;
        point = light.disc.center +
                frame_about(light.disc.normal).to_world(vec3(r * std::cos(phi), r * std::sin(phi), 0.0));
        n = light.disc.normal;
        area = pi * (light.disc.radius * light.disc.radius);
    }
    const Real distance = glm::length(point - p);
    const vec3 direction = (point - p) / distance;
    const Real cosine = dot(-direction, unit(n));
    if (cosine <= 0) return {direction, distance, 0};
    return {direction, distance, distance * distance / (area * cosine)};
}
