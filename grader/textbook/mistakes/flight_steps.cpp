// says: steps of a tenth of the mean distance, and whole numbers of them; expected -log(1 - u) / extinction itself
Real free_flight(Real extinction, Real u) {
    const Real step = 0.1 / extinction;
    Real t = 0;
    Real transmittance = 1;
    while (transmittance > 1 - u) {
        t += step;
        transmittance *= 0.9;
    }
    return t;
}
