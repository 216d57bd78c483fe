// says: extinction * exp(-extinction * u), the density of the distance
Real free_flight(Real extinction, Real u) { return extinction * std::exp(-extinction * u); }
