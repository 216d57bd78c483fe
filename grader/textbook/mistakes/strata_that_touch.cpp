// says: strata that touch: each begins where the one before ends, in place of stratum.low
Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    Real total = 0;
    Real low = strata[0].low;
    for (const Stratum& s : strata) {
        const Real width = s.high - s.low;
        Real sum = 0;
        for (const Real u : s.u) sum += f(low + u * width);
        if (!s.u.empty()) total += sum * width / Real(s.u.size());
        low += width;
    }
    return total;
}
