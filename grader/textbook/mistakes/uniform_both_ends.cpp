// says: points from a to b, both ends among them, i / (n - 1); expected the middles of n steps, (i + 0.5) / n
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    Real sum = 0;
    for (int i = 0; i < n; ++i) sum += f(a + i * (b - a) / (n - 1));
    return sum * (b - a) / n;
}
