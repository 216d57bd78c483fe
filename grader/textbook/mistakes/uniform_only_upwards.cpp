// says: a loop that runs upwards, while x < b: nothing is added where b < a
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    const Real step = (b - a) / n;
    Real sum = 0;
    for (int i = 0; i < n; ++i)
        if (a + (i + 0.5) * step < b) sum += f(a + (i + 0.5) * step);
    return sum * step;
}
