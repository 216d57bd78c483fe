// says: near and far compared with the distance from the plane; expected with t = that over dot(n, direction)
Real hit_quad(const Quad& quad, const Ray& ray) {
    const Real t = hit_quad(quad, Ray{ray.origin, ray.direction, 0, inf});
    const vec3 n = unit(cross(quad.u, quad.v));
    const Real height = std::abs(dot(quad.center - ray.origin, n));
    return height > ray.near && height < ray.far ? t : inf;
}
