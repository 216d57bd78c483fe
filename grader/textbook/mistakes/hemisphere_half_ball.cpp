// says: z plus a direction of the upper half of the sphere; expected one of the whole sphere, with 1 - 2 * u.x
DirectionSample cosine_hemisphere(vec2 u) {
    const vec2 circle = safe_sqrt(1 - u.x * u.x) * unit_circle(u.y);
    const vec3 direction = unit(vec3(circle.x, circle.y, 1 + u.x));
    return {direction, direction.z / pi};
}
