// says: each u stretched over one of N parts of its stratum, (j + u) / N; expected over all of it, low + u * its width
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real all = 0;
    for (const Stratum& s : strata) {
        const Real part = (s.high - s.low) / Real(s.u.size());
        for (std::size_t j = 0; j < s.u.size(); ++j) all += f(s.low + (Real(j) + s.u[j]) * part) * part;
    }
    return all;
}
