Real hit_quad(const Quad& quad, const Ray& ray) {
    const vec3 n = unit(cross(quad.u, quad.v));
    const Real slope = dot(ray.direction, n);
    if (slope == 0) return inf;
    const Real t = dot(n, quad.center - ray.origin) / slope;
    if (t <= ray.near || t >= ray.far) return inf;
    const vec3 p = ray.origin + t * ray.direction - quad.center;
    const Real a = dot(p, quad.u) / dot(quad.u, quad.u);
    const Real b = dot(p, quad.v) / dot(quad.v, quad.v);
    if (std::abs(a) > 1 || std::abs(b) > 1) return inf;
    return t;
}
