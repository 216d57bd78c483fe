// says: exp(-u * extinction); expected -log(1 - u) / extinction
Real free_flight(Real extinction, Real u) { return std::exp(-u * extinction); }
