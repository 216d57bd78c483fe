// says: a sum that is a whole number: its decimals are lost at each step
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    const Real step = (b - a) / n;
    Real sum = 0;
    for (int i = 0; i < n; ++i) sum = std::trunc(sum + f(a + (i + 0.5) * step));
    return sum * step;
}
