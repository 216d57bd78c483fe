// says: equal angles for equal steps on the film, tan(x * half angle); on a flat film it is x * tan(half angle)
Ray camera_ray(const Camera& camera, vec2 film) {
    const Real half = std::atan(camera.tan_half_fov);
    const Real x = std::tan(half * (2 * film.x - camera.size.x) / camera.size.y);
    const Real y = std::tan(half * (camera.size.y - 2 * film.y) / camera.size.y);
    return {camera.eye, unit(x * camera.right + y * camera.up - camera.back), 0, inf};
}
