Real shutter_time(const Shutter& shutter, Real u) { return shutter.open + u * (shutter.close - shutter.open); }
