// says: the trapezoid rule, f at the ends of the steps; expected f at their middles
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    const Real step = (b - a) / n;
    Real sum = 0;
    for (int i = 0; i < n; ++i) sum += (f(a + i * step) + f(a + (i + 1) * step)) / 2;
    return sum * step;
}
