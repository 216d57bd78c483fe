// says: the density 1 / (2 * pi) of uniform directions, in place of z / pi, that of the directions here
DirectionSample cosine_hemisphere(vec2 u) { return {cosine_hemisphere(u).direction, 1 / (2 * pi)}; }
