#include "rt/elementary.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "catch.h"

using rt::inf;
using rt::Real;

namespace {

/// |a - b| in units of the last place of b.
Real apart(Real a, long double b) {
    const Real near = Real(b);
    if (a == near) return 0;
    const Real unit = std::nextafter(std::abs(near), inf) - std::abs(near);
    return Real(std::abs(a - b) / unit);
}

/// Numbers of all sizes up to `most`, of both signs.
class Anything {
public:
    explicit Anything(Real most) : most_(most) {}
    Real operator()() {
        const Real size = std::ldexp(unit_(engine_), -int(engine_() % 60));
        return (engine_() & 1 ? most_ : -most_) * size;
    }

private:
    Real most_;
    std::mt19937_64 engine_{7};
    std::uniform_real_distribution<Real> unit_{0, 1};
};

}  // namespace

TEST_CASE("exponential and logarithm are within two units of the last place") {
    Real worst_exp = 0, worst_expm1 = 0, worst_log = 0, worst_log1p = 0;
    for (const Real most : {1.0, 30.0, 700.0}) {
        Anything any(most);
        for (int k = 0; k < 200'000; ++k) {
            const Real x = any();
            worst_exp = std::max(worst_exp, apart(rt::exp(x), std::exp((long double)x)));
            worst_expm1 = std::max(worst_expm1, apart(rt::expm1(x), std::expm1((long double)x)));
            worst_log = std::max(worst_log, apart(rt::log(std::abs(x)), std::log((long double)std::abs(x))));
            if (x > -1) {
                worst_log = std::max(worst_log, apart(rt::log(1 + x), std::log((long double)(1 + x))));
                worst_log1p = std::max(worst_log1p, apart(rt::log1p(x), std::log1p((long double)x)));
            }
        }
    }
    CHECK(worst_exp < 2);
    CHECK(worst_expm1 < 2);
    CHECK(worst_log < 2);
    CHECK(worst_log1p < 2);
}

TEST_CASE("the arc tangent is within three units of the last place, in every quadrant and on the axes") {
    Anything any(10);
    Real worst = 0;
    for (int k = 0; k < 500'000; ++k) {
        const rt::vec2 v(any(), any());
        worst =
            std::max(worst, apart(std::abs(rt::angle_of(v)), std::abs(std::atan2((long double)v.y, (long double)v.x))));
        REQUIRE(std::signbit(rt::angle_of(v)) == std::signbit(v.y));
    }
    CHECK(worst < 3);
    for (const rt::vec2 v :
         {rt::vec2(1, 0), rt::vec2(-1, 0), rt::vec2(0, 2), rt::vec2(0, -2), rt::vec2(3, 3), rt::vec2(-1, -1)})
        CHECK(rt::angle_of(v) == Approx(std::atan2(v.y, v.x)).epsilon(1e-15));
}

TEST_CASE("exponential and logarithm end as the standard library's do") {
    for (const Real x : {0.0, 1.0, -1.0, 1e-310, 709.7, 709.8, 1e308, inf, -700.0, -744.0, -746.0, -1e300, -inf}) {
        INFO("x = " << x);
        CHECK(rt::exp(x) == Approx(std::exp(x)).epsilon(1e-15).margin(5e-324));
        CHECK(rt::expm1(x) == Approx(std::expm1(x)).epsilon(1e-15).margin(1e-322));
        if (x >= 0) CHECK(rt::log(x) == Approx(std::log(x)).epsilon(1e-15));
        if (x >= -1) CHECK(rt::log1p(x) == Approx(std::log1p(x)).epsilon(1e-15));
    }
    CHECK(rt::log(0) == -inf);
    CHECK(rt::log1p(-1) == -inf);
    CHECK(rt::log(5e-324) == Approx(std::log(5e-324)).epsilon(1e-15));
    for (const Real x : {std::nan(""), -1.5}) {
        INFO("x = " << x);
        CHECK(std::isnan(rt::log(x)));
        CHECK(std::isnan(rt::log1p(x)));
    }
    CHECK(std::isnan(rt::exp(std::nan(""))));
    CHECK(std::isnan(rt::expm1(std::nan(""))));
}
