Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    const Real sin1 = safe_sqrt(1 - cosine * cosine);
    const Real sin2 = ior_from / ior_to * sin1;
    if (sin2 > 1) return 1;
    if (ior_from == ior_to) return 0;
    const Real c2 = safe_sqrt(1 - sin2 * sin2);
    const Real s = (ior_from * cosine - ior_to * c2) / (ior_from * cosine + ior_to * c2);
    const Real p = (ior_from * c2 - ior_to * cosine) / (ior_from * c2 + ior_to * cosine);
    return 0.5 * (s * s + p * p);
}
