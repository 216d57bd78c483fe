#include <vector>

#include "catch.h"
#include "random.h"
#include "rt/fragments.h"

using namespace rt;

namespace {

const Function cubic = [](Real x) { return 4 * x * x * x - 3 * x + 2; };  // over [-1, 2]: 15 - 4.5 + 6
const Real cubic_integral = 16.5;

/// One random number in each of n equal intervals.
Real stratified(const Function& f, Real a, Real b, int n, Random& random) {
    std::vector<Real> u(std::size_t(n), 0);
    std::vector<Stratum> strata;
    for (int i = 0; i < n; ++i) {
        u[std::size_t(i)] = random.number();
        strata.push_back({a + (b - a) * i / n, a + (b - a) * (i + 1) / n, {&u[std::size_t(i)], 1}});
    }
    return integrate_stratified(f, strata);
}

Real monte_carlo(const Function& f, Real a, Real b, int n, Random& random) {
    std::vector<Real> x;
    for (int i = 0; i < n; ++i) x.push_back(random.between(a, b));
    return integrate_monte_carlo(
        f, [=](Real) { return 1 / (b - a); }, x);
}

Real rms_error(const std::function<Real()>& estimate, Real truth) {
    Real sum = 0;
    for (int i = 0; i < 400; ++i) sum += sqr(estimate() - truth);
    return std::sqrt(sum / 400);
}

}  // namespace

TEST_CASE("integrate_uniform: exact for straight lines, and the error falls as 1/n^2") {
    CHECK(integrate_uniform([](Real x) { return 3 * x + 1; }, -2, 5, 1) == Approx(38.5).epsilon(1e-14));
    CHECK(integrate_uniform([](Real x) { return 3 * x + 1; }, -2, 5, 1000) == Approx(38.5).epsilon(1e-14));
    const Real coarse = integrate_uniform(cubic, -1, 2, 10) - cubic_integral;
    const Real fine = integrate_uniform(cubic, -1, 2, 100) - cubic_integral;
    CHECK(coarse / fine == Approx(100).epsilon(1e-3));
}

TEST_CASE("integrate_uniform: bounds the other way round change the sign") {
    CHECK(integrate_uniform(cubic, 2, -1, 64) == Approx(-integrate_uniform(cubic, -1, 2, 64)).epsilon(1e-14));
}

TEST_CASE("integrate_uniform: a signal at the sampling frequency aliases; random points do not") {
    const int n = 64;
    const Function wave = [=](Real x) { return 1 + std::cos(2 * pi * n * (x - 0.5 / n)); };
    CHECK(integrate_uniform(wave, 0, 1, n) == Approx(2).epsilon(1e-9));
    Random random(1);
    CHECK(monte_carlo(wave, 0, 1, 100000, random) == Approx(1).margin(0.01));
    CHECK(stratified(wave, 0, 1, 10000, random) == Approx(1).margin(0.01));
}

TEST_CASE("integrate_monte_carlo: no error at all where the density is proportional to the integrand") {
    const Function f = [](Real x) { return 6 * x; }, density = [](Real x) { return 2 * x; };
    const std::vector<Real> x = {0.1, 0.5, 0.9};
    CHECK(integrate_monte_carlo(f, density, x) == Approx(3).epsilon(1e-14));
}

TEST_CASE("integrate_monte_carlo: points of any density give the integral; importance sampling finds a sharp peak") {
    Random random(2);
    const Real width = 1e-3;
    const Function peak = [=](Real x) { return std::exp(-x / width) / width; };  // over [0, 1]: 1
    const Real plain = rms_error([&] { return monte_carlo(peak, 0, 1, 1000, random); }, 1);
    const Function density = [=](Real x) { return std::exp(-x / (2 * width)) / (2 * width); };
    const Real important = rms_error(
        [&] {
            std::vector<Real> x;
            for (int i = 0; i < 1000; ++i) x.push_back(-2 * width * std::log1p(-random.number()));
            return integrate_monte_carlo(peak, density, x);
        },
        1);
    CHECK(plain == Approx(std::sqrt(1 / (2 * width) / 1000)).epsilon(0.15));  // sd of the integrand / sqrt(n)
    CHECK(important == Approx(std::sqrt((4.0 / 3 - 1) / 1000)).epsilon(0.15));
}

TEST_CASE("integrate_monte_carlo: no points give 0") {
    CHECK(integrate_monte_carlo(cubic, [](Real) { return 1.0; }, {}) == 0);
}

TEST_CASE("integrate_stratified: the error falls as n^-3/2, of random points as n^-1/2") {
    Random random(3);
    const auto ratio = [&](auto estimate) {
        return rms_error([&] { return estimate(cubic, -1, 2, 8, random); }, cubic_integral) /
               rms_error([&] { return estimate(cubic, -1, 2, 128, random); }, cubic_integral);
    };
    CHECK(ratio(stratified) == Approx(64).epsilon(0.25));
    CHECK(ratio(monte_carlo) == Approx(4).epsilon(0.25));
}

TEST_CASE("integrate_stratified: unequal strata, each with its own number of points") {
    const std::vector<Real> u = {0.25, 0.75, 0.5, 0.1, 0.3, 0.5, 0.7, 0.9};
    const std::span<const Real> all(u);
    const std::vector<Stratum> strata = {
        {0, 1, all.subspan(0, 2)}, {1, 4, all.subspan(2, 1)}, {4, 6, all.subspan(3, 5)}};
    // points symmetric about each middle: exact for a straight line
    CHECK(integrate_stratified([](Real x) { return x; }, strata) == Approx(18).epsilon(1e-14));
}

TEST_CASE("integrate_stratified: a stratum without points adds nothing") {
    const std::vector<Real> u = {0.5};
    const std::vector<Stratum> strata = {{0, 1, {}}, {1, 3, u}};
    CHECK(integrate_stratified([](Real) { return 1.0; }, strata) == Approx(2).epsilon(1e-14));
    CHECK(integrate_stratified(cubic, {}) == 0);
}

TEST_CASE("all estimators of one integral agree") {
    Random random(4);
    const Function f = [](Real x) { return std::sin(3 * x) * std::exp(x) + 2; };
    const Real truth = integrate_uniform(f, 0, 2, 100000);
    CHECK(monte_carlo(f, 0, 2, 1000000, random) == Approx(truth).epsilon(5e-3));
    CHECK(stratified(f, 0, 2, 10000, random) == Approx(truth).epsilon(1e-5));
}
