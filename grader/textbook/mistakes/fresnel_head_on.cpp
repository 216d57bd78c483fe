// says: the share that is mirrored straight ahead, ((n1 - n2) / (n1 + n2))^2, at every angle
Real fresnel_dielectric(Real cosine, Real ior_from, Real ior_to) {
    const Real ratio = (ior_from - ior_to) / (ior_from + ior_to);
    return ratio * ratio;
}
