// says: the product of the two amplitudes, s * p; expected the mean of their squares, (s * s + p * p) / 2
Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    const Real squared = 1 - ior_from / ior_to * (ior_from / ior_to) * (1 - cosine * cosine);
    if (squared < 0) return 1;
    if (ior_from == ior_to) return 0;
    const Real c2 = std::sqrt(squared);
    const Real s = (ior_from * cosine - ior_to * c2) / (ior_from * cosine + ior_to * c2);
    const Real p = (ior_to * cosine - ior_from * c2) / (ior_to * cosine + ior_from * c2);
    return std::abs(s * p);
}
