// says: `u` taken for seconds after `open`, and clamped to `close`; u is a share: expected open + u * (close - open)
Real shutter_time(const Shutter& shutter, Real u) { return std::min(shutter.open + u, shutter.close); }
