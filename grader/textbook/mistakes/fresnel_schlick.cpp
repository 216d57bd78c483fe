// says: Schlick's approximation; expected Fresnel's equations
Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    const Real straight = (ior_from - ior_to) / (ior_from + ior_to);
    const Real squared = 1 - ior_from / ior_to * (ior_from / ior_to) * (1 - cosine * cosine);
    if (squared < 0) return 1;
    return straight * straight + (1 - straight * straight) * std::pow(1 - cosine, 5);
}
