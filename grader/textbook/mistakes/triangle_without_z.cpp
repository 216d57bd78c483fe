// says: the inside test by x and y alone: a triangle that stands upright on their plane is lost
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 e1 = triangle.b - triangle.a;
    const vec3 e2 = triangle.c - triangle.a;
    const vec3 n = cross(e1, e2);
    const Real along = dot(ray.direction, n);
    if (along == 0) return inf;
    const Real t = dot(triangle.a - ray.origin, n) / along;
    const vec3 p = ray.origin + t * ray.direction - triangle.a;
    const Real area = e1.x * e2.y - e1.y * e2.x;
    if (area == 0) return inf;
    const Real v = (p.x * e2.y - p.y * e2.x) / area;
    const Real w = (e1.x * p.y - e1.y * p.x) / area;
    if (v < 0 || w < 0 || v + w > 1) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
