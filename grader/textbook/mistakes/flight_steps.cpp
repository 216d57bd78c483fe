// says: steps of a tenth of the mean distance, so that distances are whole numbers of steps
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
