Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 v0 = triangle.b - triangle.a;
    const vec3 v1 = triangle.c - triangle.a;
    const vec3 n = cross(v0, v1);
    const Real t = dot(triangle.a - ray.origin, n) / dot(ray.direction, n);
    const vec3 v2 = ray.origin + t * ray.direction - triangle.a;
    const Real d00 = dot(v0, v0);
    const Real d01 = dot(v0, v1);
    const Real d11 = dot(v1, v1);
    const Real d20 = dot(v2, v0);
    const Real d21 = dot(v2, v1);
    const Real below = d00 * d11 - d01 * d01;
    const Real v = (d11 * d20 - d01 * d21) / below;
    const Real w = (d00 * d21 - d01 * d20) / below;
    if (v < 0 || w < 0 || v + w > 1) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
