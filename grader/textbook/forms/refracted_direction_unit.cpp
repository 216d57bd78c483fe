vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    const Real e = ior_from / ior_to;
    const Real c = -dot(d, n);
    const Real squared = 1 - e * e * (1 - c * c);
    if (squared < 0) return vec3(0);
    return unit(e * d + (e * c - std::sqrt(squared)) * n);
}
