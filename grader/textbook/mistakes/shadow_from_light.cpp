// says: a ray that starts at the light and goes to the surface; expected from the surface towards the light
Ray shadow_ray(const Hit& hit, vec3 to_light, Real distance) {
    if (distance == inf) return {hit.point + hit.error * hit.normal, to_light, 0, inf};
    return {hit.point + distance * to_light, -to_light, distance * (1 - short_of_light), distance * short_of_light};
}
