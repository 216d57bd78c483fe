// says: a sum that is not set back to 0 for each stratum
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real total = 0;
    Real sum = 0;
    for (const Stratum& stratum : strata) {
        if (stratum.u.empty()) continue;
        const Real width = stratum.high - stratum.low;
        for (const Real u : stratum.u) sum += f(stratum.low + u * width);
        total += width * sum / Real(stratum.u.size());
    }
    return total;
}
