Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real total = 0;
    for (const Stratum& stratum : strata) {
        if (stratum.u.empty()) continue;
        const Real width = stratum.high - stratum.low;
        Real sum = 0;
        for (const Real u : stratum.u) sum += f(stratum.low + u * width);
        total += sum * width / Real(stratum.u.size());
    }
    return total;
}
