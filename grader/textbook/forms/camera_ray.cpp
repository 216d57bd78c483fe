Ray camera_ray(const Camera& camera, vec2 film) {
    const Real scale = 2 * camera.tan_half_fov / camera.size.y;
    const Real x = scale * (film.x - 0.5 * camera.size.x);
    const Real y = scale * (0.5 * camera.size.y - film.y);
    return {camera.eye, unit(x * camera.right + y * camera.up - camera.back), 0, inf};
}
