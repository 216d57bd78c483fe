// says: the end at `distance`, where the light itself is met, not at `distance * short_of_light`; 0.001 as its start
Ray shadow_ray(const Hit& hit, vec3 to_light, Real distance) { return {hit.point, to_light, 0.001, distance}; }
