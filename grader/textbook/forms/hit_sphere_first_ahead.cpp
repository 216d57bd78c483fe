Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real discriminant = b * b - a * c;
    if (discriminant < 0) return inf;
    const Real root = std::sqrt(discriminant);
    const Real t0 = (-b - root) / a;
    const Real t1 = (-b + root) / a;
    if (t0 > ray.near) return t0 < ray.far ? t0 : inf;
    return t1 > ray.near && t1 < ray.far ? t1 : inf;
}
