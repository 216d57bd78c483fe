// says: the point tested against the box about the triangle, axis by axis; expected against its three edges
Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 n = cross(triangle.b - triangle.a, triangle.c - triangle.a);
    const Real t = dot(n, triangle.a - ray.origin) / dot(n, ray.direction);
    if (!(t > ray.near && t < ray.far)) return inf;
    const vec3 p = ray.origin + t * ray.direction;
    const vec3 low = glm::min(triangle.a, glm::min(triangle.b, triangle.c)) - vec3(1e-9);
    const vec3 high = glm::max(triangle.a, glm::max(triangle.b, triangle.c)) + vec3(1e-9);
    if (p.x < low.x || p.y < low.y || p.z < low.z) return inf;
    return p.x > high.x || p.y > high.y || p.z > high.z ? inf : t;
}
