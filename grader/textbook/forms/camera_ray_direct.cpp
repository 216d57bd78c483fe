Ray camera_ray(const Camera& camera, vec2 film) {
    const Real x = camera.tan_half_fov * (2 * film.x - camera.size.x) / camera.size.y;
    const Real y = camera.tan_half_fov * (camera.size.y - 2 * film.y) / camera.size.y;
    return {camera.eye, unit(x * camera.right + y * camera.up - camera.back), 0, inf};
}
