Ray lens_ray(const Camera& camera, const Ray& pinhole, vec2 u) {
    const vec2 lens = camera.lens_radius * uniform_disk(u).point;
    const Real t = std::min(camera.focus / -dot(pinhole.direction, camera.back), 1e12);
    const vec3 point = pinhole.origin + t * pinhole.direction;
    const vec3 start = pinhole.origin + lens.x * camera.right + lens.y * camera.up;
    return {start, unit(point - start), 0, inf};
}
