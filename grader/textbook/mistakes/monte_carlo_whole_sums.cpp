// says: a sum that is a whole number: its decimals are lost at each step
Real integrate_monte_carlo(const Function& f, const Function& density, std::span<const Real> x) {
    if (x.empty()) return 0;
    Real sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum = std::trunc(sum + f(x[i]) / density(x[i]));
    return sum / Real(x.size());
}
