Ray shadow_ray(const Hit& hit, vec3 to_light, Real distance) {
    Ray ray = spawn_ray(hit, to_light);
    ray.far = distance * short_of_light;
    return ray;
}
