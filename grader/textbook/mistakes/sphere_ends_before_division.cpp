// says: near and far compared with the root before it is divided by a = dot(direction, direction); expected after that
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real a = dot(ray.direction, ray.direction);
    const Real b = dot(f, ray.direction);
    const Real squared = b * b - a * (dot(f, f) - sphere.radius * sphere.radius);
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real first = -b - root;
    const Real last = -b + root;
    if (first > ray.near && first < ray.far) return first / a;
    return last > ray.near && last < ray.far ? last / a : inf;
}
