Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 e1 = triangle.b - triangle.a;
    const vec3 e2 = triangle.c - triangle.a;
    const vec3 p = cross(ray.direction, e2);
    const Real det = dot(e1, p);
    if (det == 0) return inf;
    const vec3 s = ray.origin - triangle.a;
    const Real u = dot(s, p) / det;
    if (u < 0 || u > 1) return inf;
    const vec3 q = cross(s, e1);
    const Real v = dot(ray.direction, q) / det;
    if (v < 0 || u + v > 1) return inf;
    const Real t = dot(e2, q) / det;
    return t > ray.near && t < ray.far ? t : inf;
}
