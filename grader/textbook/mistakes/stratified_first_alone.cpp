// says: the first u of each stratum alone; expected the mean over all of them
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real total = 0;
    for (const Stratum& stratum : strata) {
        if (stratum.u.empty()) continue;
        const Real width = stratum.high - stratum.low;
        total += width * f(stratum.low + stratum.u[0] * width);
    }
    return total;
}
