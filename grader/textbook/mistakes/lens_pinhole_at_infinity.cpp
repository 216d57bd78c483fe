// says: the pinhole's own ray where camera.focus is inf; expected parallel rays that start all over the lens
Ray lens_ray(const Camera& camera, const Ray& pinhole, vec2 u) {
    if (camera.focus == inf) return pinhole;
    const vec2 lens = camera.lens_radius * uniform_disk(u).point;
    const vec3 offset = lens.x * camera.right + lens.y * camera.up;
    const Real t = camera.focus / -dot(pinhole.direction, camera.back);
    return {pinhole.origin + offset, unit(pinhole.direction - offset / t), 0, inf};
}
