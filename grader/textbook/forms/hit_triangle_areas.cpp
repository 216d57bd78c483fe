Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const Real t = dot(triangle.a - ray.origin, n) / dot(ray.direction, n);
    const vec3 p = ray.origin + t * ray.direction;
    const Real area2 = dot(n, n);
    const Real alpha = dot(cross(triangle.c - triangle.b, p - triangle.b), n) / area2;
    const Real beta = dot(cross(triangle.a - triangle.c, p - triangle.c), n) / area2;
    const Real gamma = 1 - alpha - beta;
    if (alpha < 0 || beta < 0 || gamma < 0) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
