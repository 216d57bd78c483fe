Real free_flight(Real extinction, Real u) { return -std::log(1 - u) / extinction; }
