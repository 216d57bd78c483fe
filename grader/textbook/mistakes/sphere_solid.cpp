// says: a solid body, which a ray has hit where its interval begins inside; expected the surface: the far root there
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real squared = b * b - a * c;
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real enter = std::max((-b - root) / a, ray.near);
    return enter < std::min((-b + root) / a, ray.far) ? enter : inf;
}
