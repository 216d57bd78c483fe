// says: the mean of the strata's means times the whole width; expected the sum of each stratum's mean times its width
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real width = 0;
    Real means = 0;
    std::size_t filled = 0;
    for (const Stratum& stratum : strata) {
        width += stratum.high - stratum.low;
        if (stratum.u.empty()) continue;
        Real sum = 0;
        for (const Real u : stratum.u) sum += f(stratum.low + u * (stratum.high - stratum.low));
        means += sum / Real(stratum.u.size());
        filled += 1;
    }
    return filled == 0 ? 0 : means * width / Real(filled);
}
