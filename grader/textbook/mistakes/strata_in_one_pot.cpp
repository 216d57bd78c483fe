// says: the mean over all points, times the width of all strata that have any; expected the sum of each stratum's
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real sum = 0, width = 0, count = 0;
    for (const Stratum& s : strata) {
        if (s.u.empty()) continue;
        width += s.high - s.low;
        for (const Real u : s.u) {
            sum += f(s.low + u * (s.high - s.low));
            count += 1;
        }
    }
    return count == 0 ? 0 : width * sum / count;
}
