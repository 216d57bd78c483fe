// says: near and far compared with t before it is divided by dot(n, direction); expected after that
Real hit_quad(const Quad& quad, const Ray& ray) {
    const Real t = hit_quad(quad, Ray{ray.origin, ray.direction, 0, inf});
    const vec3 n = cross(quad.u, quad.v);
    const Real whole = std::abs(dot(quad.center - ray.origin, n));
    return whole > ray.near && whole < ray.far ? t : inf;
}
