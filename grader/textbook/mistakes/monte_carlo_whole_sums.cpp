// says: a sum that is a whole number: what is behind the point is lost at each step
Real integrate_monte_carlo(const Function& f, const Function& density, std::span<const Real> x) {
    if (x.empty()) return 0;
    int sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += f(x[i]) / density(x[i]);
    return Real(sum) / Real(x.size());
}
