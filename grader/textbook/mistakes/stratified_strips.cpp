// says: a strip of 1 / n for each cell, as high as the square
vec2 stratified_2d(int i, int n, vec2 u) { return {std::min((i + u.x) / n, below_one), u.y}; }
