// says: the point tested against the box about the quad, axis by axis; expected along u and v: |dot(p, u)| <= dot(u, u)
Real hit_quad(const Quad& quad, const Ray& ray) {
    const vec3 n = unit(cross(quad.u, quad.v));
    const Real t = dot(n, quad.center - ray.origin) / dot(ray.direction, n);
    const vec3 p = ray.origin + t * ray.direction - quad.center;
    const Real more = 1e-9 * (length(quad.u) + length(quad.v));
    if (std::abs(p.x) > std::abs(quad.u.x) + std::abs(quad.v.x) + more) return inf;
    if (std::abs(p.y) > std::abs(quad.u.y) + std::abs(quad.v.y) + more) return inf;
    if (std::abs(p.z) > std::abs(quad.u.z) + std::abs(quad.v.z) + more) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
