// says: the place on the film taken as two angles, a film that is round; on a flat one x and y are tangents
Ray camera_ray(const Camera& camera, vec2 film) {
    const Real half = std::atan(camera.tan_half_fov);
    const Real x = half * (2 * film.x - camera.size.x) / camera.size.y;
    const Real y = half * (camera.size.y - 2 * film.y) / camera.size.y;
    const vec3 direction =
        std::sin(x) * std::cos(y) * camera.right + std::sin(y) * camera.up - std::cos(x) * std::cos(y) * camera.back;
    return {camera.eye, unit(direction), 0, inf};
}
