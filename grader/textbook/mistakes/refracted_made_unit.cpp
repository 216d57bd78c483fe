// says: Snell's law with tangents in place of sines: ior_from / ior_to times what is along the surface, then unit
vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    const Real eta = ior_from / ior_to;
    const Real cosine = -dot(d, n);
    if (eta * eta * (1 - cosine * cosine) > 1) return vec3(0);
    return unit(eta * (d + cosine * n) - cosine * n);
}
