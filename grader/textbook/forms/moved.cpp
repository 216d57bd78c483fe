vec3 moved(vec3 point, vec3 velocity, Real time) { return point + time * velocity; }
