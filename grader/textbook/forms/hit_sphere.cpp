Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = 2 * dot(f, ray.direction);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return inf;
    const Real root = std::sqrt(discriminant);
    const Real t0 = (-b - root) / (2 * a);
    const Real t1 = (-b + root) / (2 * a);
    if (t0 > ray.near && t0 < ray.far) return t0;
    if (t1 > ray.near && t1 < ray.far) return t1;
    return inf;
}
