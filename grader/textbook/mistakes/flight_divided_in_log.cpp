// says: -log((1 - u) / extinction): the extinction must divide the logarithm, not what it is taken of
Real free_flight(Real extinction, Real u) { return -std::log((1 - u) / extinction); }
