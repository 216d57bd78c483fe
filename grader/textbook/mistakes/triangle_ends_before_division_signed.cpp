// says: near and far compared with t before the division by the determinant, of whatever sign; expected after it
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 e1 = triangle.b - triangle.a;
    const vec3 e2 = triangle.c - triangle.a;
    const vec3 p = cross(ray.direction, e2);
    const Real determinant = dot(e1, p);
    if (determinant == 0) return inf;
    const vec3 s = ray.origin - triangle.a;
    const vec3 q = cross(s, e1);
    const Real v = dot(s, p) / determinant;
    const Real w = dot(ray.direction, q) / determinant;
    if (v < 0 || w < 0 || v + w > 1) return inf;
    const Real whole = dot(e2, q);
    return whole > ray.near && whole < ray.far ? whole / determinant : inf;
}
