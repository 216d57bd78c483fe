// says: the origin moved by hit.error along to_light: it rises by the cosine of that; expected along hit.normal
Ray shadow_ray(const Hit& hit, vec3 to_light, Real distance) {
    return {hit.point + hit.error * to_light, to_light, 0, distance * short_of_light};
}
