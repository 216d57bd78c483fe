Real hit_quad(const Quad& quad, const Ray& ray) {
    const vec3 n = cross(quad.u, quad.v);
    const Real t = dot(quad.center - ray.origin, n) / dot(ray.direction, n);
    const vec3 p = ray.origin + t * ray.direction - quad.center;
    if (std::abs(dot(p, quad.u)) > dot(quad.u, quad.u)) return inf;
    if (std::abs(dot(p, quad.v)) > dot(quad.v, quad.v)) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
