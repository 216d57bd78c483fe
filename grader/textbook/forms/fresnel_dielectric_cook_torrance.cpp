Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    const Real e = ior_to / ior_from;
    const Real squared = e * e - 1 + cosine * cosine;
    if (squared < 0) return 1;
    if (ior_from == ior_to) return 0;
    const Real g = std::sqrt(squared);
    const Real a = (g - cosine) / (g + cosine);
    const Real b = (cosine * (g + cosine) - 1) / (cosine * (g - cosine) + 1);
    return 0.5 * a * a * (1 + b * b);
}
