// says: Snell's law with angles in place of their sines
vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    const Real cosine = std::min(-dot(d, n), 1.0);
    const Real angle = std::acos(cosine) * ior_from / ior_to;
    if (angle > pi / 2) return vec3(0);
    const Real sine = safe_sqrt(1 - cosine * cosine);
    const vec3 along = sine > 0 ? (d + cosine * n) / sine : vec3(0);
    return std::sin(angle) * along - std::cos(angle) * n;
}
