// says: (1 - exp(-extinction * u)) / extinction: the distribution in place of its inverse, -log(1 - u)
Real free_flight(Real extinction, Real u) { return (1 - std::exp(-extinction * u)) / extinction; }
