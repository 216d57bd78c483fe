LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind == Emitter::Kind::sphere) {
        const vec3 to_center = light.sphere.center - p;
        const Real far = glm::length(to_center);
        const Real sine = light.sphere.radius / far;
        const DirectionSample cone = sphere_cone(std::min(sine, 1.0), u);
        const vec3 direction = frame_about(unit(to_center)).to_world(cone.direction);
        const Real along = dot(to_center, direction);
        const Real beside2 = far * far - along * along;
        const Real half = safe_sqrt(light.sphere.radius * light.sphere.radius - beside2);
        const Real density = far > light.sphere.radius ? cone.density : 0.0;
        return {direction, along - half, density};
    }
    vec3 point = center(light);
    if (light.kind == Emitter::Kind::quad) {
        point = light.quad.center + (2 * u.x - 1) * light.quad.u + (2 * u.y - 1) * light.quad.v;
    } else {
        const Frame frame = frame_about(light.disc.normal);
        const vec2 on_disk = uniform_disk(u).point;
        point = light.disc.center + light.disc.radius * (on_disk.x * frame.x + on_disk.y * frame.y);
    }
    const vec3 to_point = point - p;
    const Real distance2 = dot(to_point, to_point);
    const Real distance = std::sqrt(distance2);
    const vec3 direction = to_point / distance;
    const Real cosine = -dot(direction, unit(normal(light)));
    const Real density = cosine > 0 ? distance2 / (cosine * area(light)) : 0.0;
    return {direction, distance, density};
}
