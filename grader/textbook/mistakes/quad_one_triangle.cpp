// says: one triangle alone, x + y <= 0 of the quad; expected both its halves
Real hit_quad(const Quad& quad, const Ray& ray) {
    const Real t = hit_quad(quad, ray);
    const vec3 p = ray.origin + t * ray.direction - quad.center;
    const Real x = dot(p, quad.u) / dot(quad.u, quad.u);
    const Real y = dot(p, quad.v) / dot(quad.v, quad.v);
    return t < inf && x + y <= 0 ? t : inf;
}
