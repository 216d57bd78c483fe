// says: Simpson's rule in each interval; expected the midpoint of each
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    const Real h = (b - a) / n;
    Real sum = 0;
    for (int i = 0; i < n; ++i) {
        const Real x = a + i * h;
        sum += h * (f(x) + 4 * f(x + h / 2) + f(x + h)) / 6;
    }
    return sum;
}
