// says: coordinates in the frame about n, which are not turned back into the world
vec3 mirror_direction(vec3 d, vec3 n) {
    const Frame frame = frame_about(n);
    return {dot(d, frame.x), dot(d, frame.y), -dot(d, frame.z)};
}
