// says: points of a sphere's whole surface with the density of a disc, 1/(pi r^2); that surface is four times as large
LightSample light_sample(const Emitter& light, vec3 p, vec2 u) {
    if (light.kind != Emitter::Kind::sphere) return light_sample(light, p, u);
    const Real z = 1 - 2 * u.x;
    const Real r = safe_sqrt(1 - z * z);
    const vec3 outward = vec3(r * unit_circle(u.y), z);
    const vec3 to_point = light.sphere.center + light.sphere.radius * outward - p;
    const Real distance2 = dot(to_point, to_point);
    const vec3 direction = to_point / std::sqrt(distance2);
    const Real cosine = -dot(direction, outward);
    const Real density = cosine > 0 ? distance2 / (cosine * pi * light.sphere.radius * light.sphere.radius) : 0.0;
    return {direction, std::sqrt(distance2), density};
}
