// says: `u` taken for seconds, and what is too late put back to the end
Real shutter_time(const Shutter& shutter, Real u) { return std::min(shutter.open + u, shutter.close); }
