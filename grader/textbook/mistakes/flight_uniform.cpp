// says: 2 * u / extinction, uniform up to twice the mean distance; expected -log(1 - u) / extinction
Real free_flight(Real extinction, Real u) { return 2 * u / extinction; }
