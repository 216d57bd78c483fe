// says: glass told channel by channel; expected all of it glass where any channel lets light through
Outgoing whitted(const Material& material, Real fresnel) {
    const Color t = material.transmittance;
    const Color clear = Color(t.x > 0 ? 1 : 0, t.y > 0 ? 1 : 0, t.z > 0 ? 1 : 0);
    const Color mirror = (fresnel * clear + Color(1) - clear) * material.reflectance;
    return {Color(1), mirror, (1 - fresnel) * material.transmittance};
}
