// says: 0 where the cosine is 1; expected ((ior_from - ior_to) / (ior_from + ior_to))^2 there
Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    return cosine >= 1 ? 0 : fresnel_dielectric(cosine, ior_from, ior_to);
}
