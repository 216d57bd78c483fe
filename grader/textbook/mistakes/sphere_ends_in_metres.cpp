// says: near and far compared with the distance in metres; expected with t, in lengths of ray.direction
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 f = ray.origin - sphere.center;
    const Real speed = length(ray.direction);
    const Real b = dot(f, ray.direction) / speed;
    const Real squared = b * b - (dot(f, f) - sphere.radius * sphere.radius);
    if (squared < 0) return inf;
    const Real root = std::sqrt(squared);
    const Real first = -b - root;
    const Real last = -b + root;
    if (first > ray.near && first < ray.far) return first / speed;
    return last > ray.near && last < ray.far ? last / speed : inf;
}
