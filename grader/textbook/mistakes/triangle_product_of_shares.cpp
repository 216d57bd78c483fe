// says: the sign of the product of the three shares, which two negative ones leave; expected each of them at least 0
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
    if (v * w * (1 - v - w) < 0) return inf;
    const Real t = dot(e2, q) / determinant;
    return t > ray.near && t < ray.far ? t : inf;
}
