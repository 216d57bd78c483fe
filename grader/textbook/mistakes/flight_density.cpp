// says: extinction * exp(-extinction * u), the density of the distance; expected -log(1 - u) / extinction
Real free_flight(Real extinction, Real u) { return extinction * std::exp(-extinction * u); }
