Ray shadow_ray(const Hit& hit, vec3 to_light, Real distance) {
    const Ray ray = spawn_ray(hit, to_light);
    return {ray.origin, ray.direction, 0, distance * short_of_light};
}
