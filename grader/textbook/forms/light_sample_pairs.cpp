LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind == Emitter::Kind::sphere) {
        const vec3 to_center = light.sphere.center - p;
        const Real distance2 = dot(to_center, to_center);
        const Real sine = light.sphere.radius / std::sqrt(distance2);
        if (sine >= 1) return {unit(to_center), 0, 0};
        const DirectionSample cone = sphere_cone(sine, u);
        const Frame frame = frame_about(unit(to_center));
        const vec3 direction = frame.to_world(cone.direction);
        const Real b = dot(to_center, direction);
        const Real c = distance2 - light.sphere.radius * light.sphere.radius;
        const Real distance = b - safe_sqrt(b * b - c);
        return {direction, distance, cone.density};
    }
    vec3 point = center(light);
    if (light.kind == Emitter::Kind::quad) {
        const vec2 at = 2.0 * u - vec2(1);
        point = light.quad.center + at.x * light.quad.u + at.y * light.quad.v;
    } else {
        const vec2 at = light.disc.radius * uniform_disk(u).point;
        point = light.disc.center + frame_about(light.disc.normal).to_world(vec3(at.x, at.y, 0.0));
    }
    const vec3 to_point = point - p;
    const Real distance = std::sqrt(dot(to_point, to_point));
    const vec3 direction = unit(to_point);
    const Real cosine = dot(unit(normal(light)), -direction);
    const Real density = distance * distance / (std::max(cosine, 0.0) * area(light));
    return {direction, distance, cosine > 0 ? density : 0.0};
}
