Outgoing whitted(const Material& material, Real fresnel) {
    const Color mirror = fresnel * material.reflectance;
    const Color glass = Color(1 - fresnel) * material.transmittance;
    if (material.transmittance == Color(0)) return {Color(1), material.reflectance, Color(0)};
    return {Color(1), mirror, glass};
}
