// says: the peak at d also where g < 0: there it must be at -d
DirectionSample scatter_direction(vec3 d, Real g, vec2 u) { return scatter_direction(d, std::abs(g), u); }
