// says: the density of the disk's point, 1 / pi per area, in place of z / pi per solid angle
DirectionSample cosine_hemisphere(vec2 u) { return {cosine_hemisphere(u).direction, 1 / pi}; }
