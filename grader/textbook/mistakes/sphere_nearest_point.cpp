// says: the point of the ray that is nearest to the centre: half of the way through the sphere is not taken off
Real hit_sphere(const Sphere& sphere, const Ray& ray) {
    const vec3 to_center = sphere.center - ray.origin;
    const Real t = dot(to_center, ray.direction) / dot(ray.direction, ray.direction);
    const vec3 beside = to_center - t * ray.direction;
    if (dot(beside, beside) > sphere.radius * sphere.radius) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
