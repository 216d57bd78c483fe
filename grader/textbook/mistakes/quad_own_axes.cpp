// says: p measured along the axes of a frame about n, not along u and v
Real hit_quad(const Quad& quad, const Ray& ray) {
    const vec3 n = unit(cross(quad.u, quad.v));
    const Real t = dot(n, quad.center - ray.origin) / dot(ray.direction, n);
    const vec3 p = ray.origin + t * ray.direction - quad.center;
    const Frame frame = frame_about(n);
    if (std::abs(dot(p, frame.x)) > length(quad.u)) return inf;
    if (std::abs(dot(p, frame.y)) > length(quad.v)) return inf;
    return t > ray.near && t < ray.far ? t : inf;
}
