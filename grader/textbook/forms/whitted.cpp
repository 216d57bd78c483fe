Outgoing whitted(const Material& material, Real fresnel) {
    const bool glass = material.transmittance.x > 0 || material.transmittance.y > 0 || material.transmittance.z > 0;
    if (!glass) return {Color(1), material.reflectance, Color(0)};
    return {Color(1), fresnel * material.reflectance, (1 - fresnel) * material.transmittance};
}
