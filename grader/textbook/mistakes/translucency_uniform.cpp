// says: directions uniform on the hemisphere about the axis, whatever the exponent is; expected those of phong_lobe
Scattered translucency(vec3 d, vec3 n, Real ior_from, Real ior_to, Real exponent, vec2 u) {
    const vec3 axis = refracted_direction(d, n, ior_from, ior_to);
    if (axis == vec3(0)) return {d, Color(0)};
    const Real z = u.x;
    const Real r = safe_sqrt(1 - z * z);
    const Real phi = 2 * pi * u.y;
    const vec3 direction = frame_about(axis).to_world({r * std::cos(phi), r * std::sin(phi), z});
    return {direction, Color((exponent + 2) / (exponent + 1) * std::max(-dot(direction, n), 0.0))};
}
