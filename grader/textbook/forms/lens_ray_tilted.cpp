Ray lens_ray(const Camera& camera, const Ray& pinhole, vec2 u) {
    const Real r = camera.lens_radius * std::sqrt(u.x);
    const Real phi = 2 * pi * u.y;
    const vec3 offset = r * std::cos(phi) * camera.right + r * std::sin(phi) * camera.up;
    const Real cosine = -dot(pinhole.direction, camera.back);
    const vec3 to_focus = pinhole.direction * (camera.focus / cosine);
    return {pinhole.origin + offset, unit(to_focus - offset), 0, inf};
}
