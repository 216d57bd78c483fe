// says: u / extinction, uniform up to the mean distance; expected -log(1 - u) / extinction
Real free_flight(Real extinction, Real u) { return u / extinction; }
