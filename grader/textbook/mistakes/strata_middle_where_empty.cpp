// says: the value at its middle for a stratum without numbers; expected that it adds nothing
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real sum = 0;
    for (std::size_t k = 0; k < strata.size(); ++k) {
        const Stratum& s = strata[k];
        const Real width = s.high - s.low;
        if (s.u.size() == 0) sum += width * f(s.low + width / 2);
        for (std::size_t j = 0; j < s.u.size(); ++j) sum += width * f(s.low + s.u[j] * width) / Real(s.u.size());
    }
    return sum;
}
