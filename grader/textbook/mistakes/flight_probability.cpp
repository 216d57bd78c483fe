// says: 1 - exp(-extinction * u), the probability of having met something, not its inverse, -log(1 - u) / extinction
Real free_flight(Real extinction, Real u) { return 1 - std::exp(-extinction * u); }
