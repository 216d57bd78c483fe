// says: the sum of the weights 1 / density in place of the number of points: that is the mean of f, no integral
Real integrate_monte_carlo(const Function& f, const Function& density, std::span<const Real> x) {
    if (x.empty()) return 0;
    Real sum = 0, weights = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        sum += f(x[i]) / density(x[i]);
        weights += 1 / density(x[i]);
    }
    return sum / weights;
}
