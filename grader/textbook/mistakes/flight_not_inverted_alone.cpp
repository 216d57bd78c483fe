// says: the distribution 1 - exp(-extinction * u) in place of its inverse, -log(1 - u) / extinction
Real free_flight(Real extinction, Real u) { return 1 - std::exp(-extinction * u); }
