// says: the root of the smaller size alone: one behind the origin hides the one ahead
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real squared = b * b - a * c;
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real t0 = (-b - root) / a;
    const Real t1 = (-b + root) / a;
    const Real t = std::abs(t0) < std::abs(t1) ? t0 : t1;
    if (t > ray.near && t < ray.far) return t;
    return inf;
}
