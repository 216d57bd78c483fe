// says: only the root next to 0, which may lie behind the ray; expected the smaller one in the interval, else the other
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real squared = b * b - a * c;
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real t = b > 0 ? (-b + root) / a : (-b - root) / a;
    return t > ray.near && t < ray.far ? t : inf;
}
