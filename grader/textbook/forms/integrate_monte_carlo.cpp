Real integrate_monte_carlo(const Function& f, const Function& density, std::span<const Real> x) {
    Real sum = 0;
    for (const Real x_i : x) sum += f(x_i) / density(x_i);
    return x.empty() ? 0 : sum / Real(x.size());
}
