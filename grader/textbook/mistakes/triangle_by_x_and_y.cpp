// says: the inside test by x and y alone: what stands upright on their plane is hit beyond its edges
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 a = triangle.a;
    const vec3 b = triangle.b;
    const vec3 c = triangle.c;
    const vec3 n = cross(b - a, c - a);
    const Real t = dot(n, a - ray.origin) / dot(n, ray.direction);
    if (!(t > ray.near && t < ray.far)) return inf;
    const vec3 p = ray.origin + t * ray.direction;
    const Real ab = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    const Real bc = (c.x - b.x) * (p.y - b.y) - (c.y - b.y) * (p.x - b.x);
    const Real ca = (a.x - c.x) * (p.y - c.y) - (a.y - c.y) * (p.x - c.x);
    if (ab >= 0 && bc >= 0 && ca >= 0) return t;
    return ab <= 0 && bc <= 0 && ca <= 0 ? t : inf;
}
