// says: Snell's law with tangents in place of sines
vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    const Real cosine = -dot(d, n);
    const Real tangent = ior_from / ior_to * safe_sqrt(1 - cosine * cosine) / cosine;
    const Real cos2 = 1 / std::sqrt(1 + tangent * tangent);
    return ior_from / ior_to / cosine * cos2 * (d + cosine * n) - cos2 * n;
}
