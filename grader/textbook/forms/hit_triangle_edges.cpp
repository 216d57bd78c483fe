Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const Real slope = dot(ray.direction, n);
    if (slope == 0) return inf;
    const Real t = dot(triangle.a - ray.origin, n) / slope;
    const vec3 p = ray.origin + t * ray.direction;
    if (dot(cross(triangle.b - triangle.a, p - triangle.a), n) < 0) return inf;
    if (dot(cross(triangle.c - triangle.b, p - triangle.b), n) < 0) return inf;
    if (dot(cross(triangle.a - triangle.c, p - triangle.c), n) < 0) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
