Real hit_triangle(const Triangle& triangle, const Ray& ray) {
    const vec3 d = ray.direction;
    const Real x = std::abs(d.x);
    const Real y = std::abs(d.y);
    const Real z = std::abs(d.z);
    const int kz = z >= x && z >= y ? 2 : y >= x ? 1 : 0;
    const int kx = (kz + 1) % 3;
    const int ky = (kz + 2) % 3;
    const vec3 a = triangle.a - ray.origin;
    const vec3 b = triangle.b - ray.origin;
    const vec3 c = triangle.c - ray.origin;
    const Real shear_x = d[kx] / d[kz];
    const Real shear_y = d[ky] / d[kz];
    const Real ax = a[kx] - shear_x * a[kz];
    const Real ay = a[ky] - shear_y * a[kz];
    const Real bx = b[kx] - shear_x * b[kz];
    const Real by = b[ky] - shear_y * b[kz];
    const Real cx = c[kx] - shear_x * c[kz];
    const Real cy = c[ky] - shear_y * c[kz];
    const Real u = cx * by - cy * bx;
    const Real v = ax * cy - ay * cx;
    const Real w = bx * ay - by * ax;
    if ((u < 0 || v < 0 || w < 0) && (u > 0 || v > 0 || w > 0)) return inf;
    const Real sum = u + v + w;
    if (sum == 0) return inf;
    const Real t = (u * a[kz] + v * b[kz] + w * c[kz]) / (sum * d[kz]);
    return t > ray.near && t < ray.far ? t : inf;
}
