// says: the shares along the two edges by themselves, dot(p, e) / dot(e, e): right where the corner has a right angle
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 e1 = triangle.b - triangle.a;
    const vec3 e2 = triangle.c - triangle.a;
    const vec3 n = cross(e1, e2);
    const Real along = dot(ray.direction, n);
    if (along == 0) return inf;
    const Real t = dot(triangle.a - ray.origin, n) / along;
    const vec3 p = ray.origin + t * ray.direction - triangle.a;
    const Real v = dot(p, e1) / dot(e1, e1);
    const Real w = dot(p, e2) / dot(e2, e2);
    if (v < 0 || w < 0 || v + w > 1) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
