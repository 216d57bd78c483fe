// says: glass only where all channels let light through; expected where any channel of the transmittance is above 0
Outgoing whitted(const Material& material, Real fresnel) {
    const Color t = material.transmittance;
    if (t.x <= 0 || t.y <= 0 || t.z <= 0) return {Color(1), material.reflectance, Color(0)};
    return {Color(1), fresnel * material.reflectance, (1 - fresnel) * t};
}
