vec3 moved(vec3 point, vec3 velocity, Real time) {
    return {point.x + time * velocity.x, point.y + time * velocity.y, point.z + time * velocity.z};
}
