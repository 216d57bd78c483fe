Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    const Real e = ior_to / ior_from;
    const Real squared = e * e - (1 - cosine * cosine);
    if (squared < 0) return 1;
    if (ior_from == ior_to) return 0;
    const Real g = std::sqrt(squared);
    const Real s = (cosine - g) / (cosine + g);
    const Real p = (e * e * cosine - g) / (e * e * cosine + g);
    return (s * s + p * p) / 2;
}
