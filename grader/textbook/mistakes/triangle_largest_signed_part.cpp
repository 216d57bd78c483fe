// says: the axis to leave out by the greatest part of the normal; expected by the largest in size, std::abs of each
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const Real along = dot(n, ray.direction);
    if (along == 0) return inf;
    const Real t = dot(n, triangle.a - ray.origin) / along;
    const vec3 p = ray.origin + t * ray.direction;
    const int out = n.x > n.y && n.x > n.z ? 0 : n.y > n.z ? 1 : 2;
    const vec3 a = triangle.a - p;
    const vec3 b = triangle.b - p;
    const vec3 c = triangle.c - p;
    const Real u = cross(b, c)[out];
    const Real v = cross(c, a)[out];
    const Real w = cross(a, b)[out];
    const Real whole = u + v + w;
    if (n[out] == 0) return inf;
    if (u / whole < 0 || v / whole < 0 || w / whole < 0) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
