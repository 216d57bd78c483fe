// says: glass told by its ior, other than 1; expected by its transmittance, any channel above 0
Outgoing whitted(const Material& material, Real fresnel) {
    if (material.ior == 1) return {Color(1), material.reflectance, Color(0)};
    return {Color(1), fresnel * material.reflectance, (1 - fresnel) * material.transmittance};
}
