// says: the phase function of Schlick, with k = 1.55 g - 0.55 g^3: close to that of Henyey and Greenstein, but another
DirectionSample scatter_direction(vec3 d, Real g, vec2 u) {
    const Real k = 1.55 * g - 0.55 * g * g * g;
    const Real c = (2 * u.x + k - 1) / (1 - k + 2 * k * u.x);
    const Real s = safe_sqrt(1 - c * c);
    const vec2 circle = unit_circle(u.y);
    return {frame_about(d).to_world({s * circle.x, s * circle.y, c}), (1 - k * k) / (4 * pi * sqr(1 - k * c))};
}
