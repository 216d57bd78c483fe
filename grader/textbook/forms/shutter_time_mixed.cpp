Real shutter_time(const Shutter& shutter, Real u) { return (1 - u) * shutter.open + u * shutter.close; }
