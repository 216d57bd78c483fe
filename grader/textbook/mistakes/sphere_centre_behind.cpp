// says: no hit where the centre is behind the origin, though the origin may lie in the sphere
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    if (b > 0) return inf;
    const Real squared = b * b - a * (dot(f, f) - sphere.radius * sphere.radius);
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real t0 = (-b - root) / a;
    const Real t1 = (-b + root) / a;
    if (t0 > ray.near && t0 < ray.far) return t0;
    if (t1 > ray.near && t1 < ray.far) return t1;
    return inf;
}
