LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind == Emitter::Kind::sphere) {
        const vec3 to_center = light.sphere.center - p;
        const Real far = glm::length(to_center);
        const DirectionSample cone = sphere_cone(std::min(light.sphere.radius / far, 1.0), u);
        const vec3 direction = frame_about(to_center / far).to_world(cone.direction);
        const Real cosine = dot(unit(to_center), direction);
        const Real sine2 = 1 - cosine * cosine;
        const Real half = safe_sqrt(light.sphere.radius * light.sphere.radius - far * far * sine2);
        return {direction, far * cosine - half, far > light.sphere.radius ? cone.density : 0.0};
    }
    vec3 point = center(light);
    if (light.kind == Emitter::Kind::quad) {
        const vec3 corner = light.quad.center - light.quad.u - light.quad.v;
        point = corner + 2 * u.x * light.quad.u + 2 * u.y * light.quad.v;
    } else {
        const Real r = light.disc.radius * std::sqrt(u.x);
        const Real phi = 2 * pi * u.y;
        const Frame frame = frame_about(light.disc.normal);
        point = light.disc.center + r * std::cos(phi) * frame.x + r * std::sin(phi) * frame.y;
    }
    const vec3 to_point = point - p;
    const Real distance = glm::length(to_point);
    const vec3 direction = to_point / distance;
    const Real cosine = -dot(unit(normal(light)), direction);
    if (cosine <= 0) return {direction, distance, 0};
    const Real of_area = 1 / area(light);
    return {direction, distance, of_area * distance * distance / cosine};
}
