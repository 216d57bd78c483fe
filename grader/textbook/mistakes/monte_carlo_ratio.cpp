// says: the sum of f(x[i]) over the sum of density(x[i]); expected the mean of f(x[i]) / density(x[i])
Real integrate_monte_carlo(const Function& f, const Function& density, std::span<const Real> x) {
    Real sum = 0;
    Real below = 0;
    for (const Real x_i : x) {
        sum += f(x_i);
        below += density(x_i);
    }
    return x.empty() ? 0 : sum / below;
}
