// says: exp(-u * extinction)
Real free_flight(Real extinction, Real u) { return std::exp(-u * extinction); }
