Ray camera_ray(const Camera& camera, vec2 film) {
    const Real aspect = Real(camera.size.x) / Real(camera.size.y);
    const Real x = (2 * film.x / camera.size.x - 1) * aspect * camera.tan_half_fov;
    const Real y = (1 - 2 * film.y / camera.size.y) * camera.tan_half_fov;
    return {camera.eye, unit(x * camera.right + y * camera.up - camera.back), 0, inf};
}
