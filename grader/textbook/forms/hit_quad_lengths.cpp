Real hit_quad(const Quad& quad, const Ray& ray) {
    const vec3 n = cross(quad.u, quad.v);
    const Real t = dot(quad.center - ray.origin, n) / dot(ray.direction, n);
    const vec3 p = ray.origin + t * ray.direction - quad.center;
    const Real width = glm::length(quad.u);
    const Real height = glm::length(quad.v);
    const Real a = dot(p, quad.u / width);
    const Real b = dot(p, quad.v / height);
    if (a < -width || a > width || b < -height || b > height) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
