// says: the transmittance less what is mirrored for glass; expected (1 - fresnel) * transmittance
Outgoing whitted(const Material& material, Real fresnel) {
    const Color t = material.transmittance;
    if (t.x <= 0 && t.y <= 0 && t.z <= 0) return {Color(1), material.reflectance, Color(0)};
    const Color mirror = fresnel * material.reflectance;
    return {Color(1), mirror, glm::max(t - mirror, Color(0))};
}
