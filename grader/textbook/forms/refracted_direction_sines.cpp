vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    const Real cos1 = -dot(d, n);
    const Real sin1 = safe_sqrt(1 - cos1 * cos1);
    const Real sin2 = ior_from / ior_to * sin1;
    if (sin2 > 1) return vec3(0);
    const Real cos2 = std::sqrt(1 - sin2 * sin2);
    return ior_from / ior_to * (d + cos1 * n) - cos2 * n;
}
