// says: t in metres, along a direction of length 1, times the length of ray.direction; expected divided by it
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real speed = length(ray.direction);
    const Real b = dot(f, ray.direction) / speed;
    const Real squared = b * b - (dot(f, f) - sphere.radius * sphere.radius);
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real near = (-b - root) * speed;
    const Real far = (-b + root) * speed;
    if (near > ray.near && near < ray.far) return near;
    return far > ray.near && far < ray.far ? far : inf;
}
