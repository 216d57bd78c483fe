// says: rays that all meet in the middle of the plane in focus; expected where the pinhole's ray meets that plane
Ray lens_ray(const Camera& camera, const Ray& pinhole, vec2 u) {
    const vec2 lens = camera.lens_radius * uniform_disk(u).point;
    const vec3 offset = lens.x * camera.right + lens.y * camera.up;
    if (camera.focus == inf) return {pinhole.origin + offset, pinhole.direction, 0, inf};
    return {pinhole.origin + offset, unit(-camera.focus * camera.back - offset), 0, inf};
}
