// says: near and far compared with the distance from the plane; expected with t = that over dot(n, direction)
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const Real t = hit_triangle(triangle, Ray{ray.origin, ray.direction, 0, inf});
    const vec3 n = unit(cross(triangle.b - triangle.a, triangle.c - triangle.a));
    const Real height = std::abs(dot(triangle.a - ray.origin, n));
    return height > ray.near && height < ray.far ? t : inf;
}
