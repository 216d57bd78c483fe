// says: -log(1 - u / extinction): u is divided by the extinction, not the logarithm
Real free_flight(Real extinction, Real u) { return -std::log(1 - u / extinction); }
