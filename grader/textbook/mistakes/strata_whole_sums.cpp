// says: a sum that is a whole number: its decimals are lost at each stratum
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real all = 0;
    for (const Stratum& s : strata) {
        if (s.u.empty()) continue;
        Real sum = 0;
        for (const Real u : s.u) sum += f(s.low + u * (s.high - s.low));
        all = std::trunc(all + (s.high - s.low) * sum / Real(s.u.size()));
    }
    return all;
}
