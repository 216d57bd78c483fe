// says: `u` taken for a time, and put into the exposure where it is before or after it
Real shutter_time(const Shutter& shutter, Real u) { return std::min(std::max(u, shutter.open), shutter.close); }
