Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const Real speed = glm::length(ray.direction);
    const vec3 d = ray.direction / speed;
    const vec3 to_center = sphere.center - ray.origin;
    const Real along = dot(to_center, d);
    const Real beside2 = dot(to_center, to_center) - along * along;
    const Real radius2 = sphere.radius * sphere.radius;
    if (beside2 > radius2) return inf;
    const Real half = std::sqrt(radius2 - beside2);
    const Real t0 = (along - half) / speed;
    const Real t1 = (along + half) / speed;
    if (t0 > ray.near && t0 < ray.far) return t0;
    if (t1 > ray.near && t1 < ray.far) return t1;
    return inf;
}
