// says: `u` taken for a time, and clamped to the exposure; u is a share of it: expected open + u * (close - open)
Real shutter_time(const Shutter& shutter, Real u) { return std::min(std::max(u, shutter.open), shutter.close); }
