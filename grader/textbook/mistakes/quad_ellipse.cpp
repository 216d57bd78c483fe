// says: x * x + y * y <= 1, an ellipse within the quad; expected abs(x) <= 1 and abs(y) <= 1, each by itself
Real hit_quad(const Quad& quad, const Ray& ray) {
    const vec3 n = cross(quad.u, quad.v);
    const Real t = dot(quad.center - ray.origin, n) / dot(ray.direction, n);
    const vec3 p = ray.origin + t * ray.direction - quad.center;
    const Real x = dot(p, quad.u) / dot(quad.u, quad.u);
    const Real y = dot(p, quad.v) / dot(quad.v, quad.v);
    return x * x + y * y <= 1 && t > ray.near && t < ray.far ? t : inf;
}
