// says: points from a to b with both ends among them, and n - 1 steps between them; expected the middles of n equal steps, (i + 0.5) / n
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    Real sum = 0;
    for (int i = 0; i < n; ++i) sum += f(a + i * (b - a) / (n - 1));
    return sum * (b - a) / (n - 1);
}
