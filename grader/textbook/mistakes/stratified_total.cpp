// says: the mean of all values times the whole width: strata with many numbers count too much
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real width = 0;
    Real sum = 0;
    std::size_t count = 0;
    for (const Stratum& stratum : strata) {
        width += stratum.high - stratum.low;
        for (const Real u : stratum.u) sum += f(stratum.low + u * (stratum.high - stratum.low));
        count += stratum.u.size();
    }
    return count == 0 ? 0 : sum * width / Real(count);
}
