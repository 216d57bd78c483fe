// says: the middle of the next step in each: is x advanced before f is asked? Each point is one step too far
Real integrate_uniform(const Function& f, Real a, Real b, int n) {
    const Real step = (b - a) / n;
    Real sum = 0;
    for (int i = 0; i < n; ++i) sum += f(a + (i + 1.5) * step);
    return sum * step;
}
