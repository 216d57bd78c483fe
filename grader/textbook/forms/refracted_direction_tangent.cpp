vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    const Real cosine = dot(d, n);
    const vec3 tangent = ior_from / ior_to * (d - cosine * n);
    const Real length2 = dot(tangent, tangent);
    if (length2 > 1) return vec3(0);
    return tangent - std::sqrt(1 - length2) * n;
}
