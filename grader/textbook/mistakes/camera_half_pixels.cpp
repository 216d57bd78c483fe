// says: size / 2 as a division of whole numbers: of an odd number of pixels the middle is half a pixel off
Ray camera_ray(const Camera& camera, vec2 film) {
    const Real scale = 2 * camera.tan_half_fov / camera.size.y;
    const Real x = scale * (film.x - std::floor(0.5 * camera.size.x));
    const Real y = scale * (std::floor(0.5 * camera.size.y) - film.y);
    return {camera.eye, unit(x * camera.right + y * camera.up - camera.back), 0, inf};
}
