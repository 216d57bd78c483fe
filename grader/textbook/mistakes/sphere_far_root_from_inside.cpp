// says: the far root only for rays that start inside; expected wherever the near one is not beyond ray.near
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    const Real c = dot(f, f) - sphere.radius * sphere.radius;
    const Real squared = b * b - a * c;
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real t = c < 0 ? (-b + root) / a : (-b - root) / a;
    return t > ray.near && t < ray.far ? t : inf;
}
