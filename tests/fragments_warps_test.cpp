#include "catch.h"
#include "random.h"
#include "rt/fragments.h"
#include "warp.h"

using namespace rt;

namespace {

constexpr Real almost_one = 1 - 0x1p-32;  // the samplers' greatest number, or nearly

/// Unit length; where the map stretches areas the density is lower by as much; and samples follow the distribution of
/// the cosine to the z axis, evenly around it. cumulative(c): the probability of a cosine below c.
template <class Warp, class Cumulative>
void check_warp(Warp warp, Cumulative cumulative) {
    Random random(1);
    for (int i = 0; i < 300; ++i) {
        const vec2 u = 0.001 + 0.998 * random.point();
        const DirectionSample sample = warp(u);
        INFO("u " << text(u) << ", direction " << text(sample.direction) << ", density " << sample.density);
        CHECK(dot(sample.direction, sample.direction) == Approx(1).epsilon(1e-12));
        CHECK(sample.density * area_stretch([&](vec2 v) { return warp(v).direction; }, u) == Approx(1).epsilon(1e-4));
    }
    const Real p = uniform_probability([&] {
        const vec3 d = warp(random.point()).direction;
        return vec2(cumulative(d.z), turn(d.x, d.y));
    });
    CHECK(p > 1e-4);
    for (const Real x : {0.0, almost_one})
        for (const Real y : {0.0, almost_one}) {
            const DirectionSample corner = warp({x, y});
            INFO("u " << x << ", " << y << ", direction " << text(corner.direction) << ", density " << corner.density);
            CHECK(dot(corner.direction, corner.direction) == Approx(1).epsilon(1e-12));
            CHECK((corner.density >= 0 && corner.density < inf));
        }
}

}  // namespace

TEST_CASE("stratified_2d: the cells tile the unit square, whatever their number") {
    for (int n = 1; n <= 130; ++n) {
        std::vector<vec2> low, high;
        Real area = 0;
        for (int i = 0; i < n; ++i) {
            low.push_back(stratified_2d(i, n, vec2(0)));
            high.push_back(stratified_2d(i, n, vec2(almost_one)));
            const vec2 size = high.back() - low.back();
            INFO("cell " << i << " of " << n << ": " << text(low.back()) << " to " << text(high.back()));
            CHECK(size.x * size.y == Approx(1.0 / n).epsilon(1e-8));
            CHECK((low.back().x >= 0 && low.back().y >= 0 && high.back().x < 1 && high.back().y < 1));
            area += size.x * size.y;
        }
        CHECK(area == Approx(1).epsilon(1e-8));
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < i; ++j) {
                const vec2 a = glm::dvec2(std::max(low[i].x, low[j].x), std::max(low[i].y, low[j].y));
                const vec2 b = glm::dvec2(std::min(high[i].x, high[j].x), std::min(high[i].y, high[j].y));
                if (b.x - a.x > 1e-9 && b.y - a.y > 1e-9)
                    FAIL_CHECK("cells " << i << " and " << j << " of " << n << " overlap");
            }
    }
}

TEST_CASE("stratified_2d: a square number of cells is a grid, one sample in each row of each column") {
    Random random(2);
    for (const int side : {1, 2, 3, 7, 16}) {
        std::vector<int> count(std::size_t(side * side), 0);
        for (int i = 0; i < side * side; ++i) {
            const vec2 p = stratified_2d(i, side * side, random.point());
            ++count[std::size_t(int(p.y * side) * side + int(p.x * side))];
        }
        for (const int each : count) CHECK(each == 1);
    }
}

TEST_CASE("stratified_2d: inside the unit square up to a million cells") {
    for (const int n : {1000, 4096, 65535, 65536, 1000000})
        for (const int i : {0, 1, n / 3, n - 2, n - 1}) {
            const vec2 p = stratified_2d(i, n, vec2(almost_one));
            INFO("cell " << i << " of " << n << ": " << text(p));
            CHECK((p.x < 1 && p.y < 1 && p.x >= 0 && p.y >= 0));
        }
}

TEST_CASE("uniform_disk: the density is one over the area, everywhere, and all parts of the disk get their share") {
    Random random(3);
    for (int i = 0; i < 300; ++i) {
        const vec2 u = 0.001 + 0.998 * random.point();
        INFO("u " << text(u));
        const auto in_space = [](vec2 v) { return vec3(uniform_disk(v).point, 0); };
        CHECK(uniform_disk(u).density == Approx(1 / pi));
        CHECK(area_stretch(in_space, u) == Approx(pi).epsilon(1e-4));
    }
    const Real p = uniform_probability([&] {
        const vec2 point = uniform_disk(random.point()).point;
        CHECK(dot(point, point) <= 1);
        return vec2(dot(point, point), turn(point.x, point.y));
    });
    CHECK(p > 1e-4);
}

TEST_CASE("cosine_hemisphere: density, distribution, corners of the square") {
    check_warp(cosine_hemisphere, [](Real c) { return c * c; });
    Random random(4);
    for (int i = 0; i < 1000; ++i) {
        const DirectionSample sample = cosine_hemisphere(random.point());
        CHECK(sample.direction.z >= 0);
        CHECK(sample.density == Approx(sample.direction.z / pi).epsilon(1e-12));
    }
}

TEST_CASE("phong_lobe: density, distribution, corners of the square") {
    const Real exponent = GENERATE(0.0, 1.0, 2.5, 10.0, 50.0, 1000.0);
    INFO("exponent " << exponent);
    check_warp([=](vec2 u) { return phong_lobe(exponent, u); }, [=](Real c) { return std::pow(c, exponent + 1); });
}

TEST_CASE("phong_lobe: E cos = (n+1)/(n+2) and E sin^2 = 2/(n+3), for the narrowest lobes too") {
    for (const Real n : {0.0, 1.0, 10.0, 1e3, 1e6, 1e9}) {
        INFO("exponent " << n);
        const Real cosine = square_mean(400, [=](vec2 u) { return phong_lobe(n, u).direction.z; });
        const Real sine2 = square_mean(400, [=](vec2 u) {
            const vec3 d = phong_lobe(n, u).direction;
            return d.x * d.x + d.y * d.y;
        });
        CHECK(cosine == Approx((n + 1) / (n + 2)).epsilon(1e-4));
        CHECK(sine2 == Approx(2 / (n + 3)).epsilon(1e-2));
    }
}

TEST_CASE("sphere_cone: density, distribution, corners of the square") {
    const Real sine = GENERATE(1.0, 0.9, 0.5, 0.1);
    INFO("sine " << sine);
    const Real least = std::sqrt(1 - sine * sine);
    check_warp([=](vec2 u) { return sphere_cone(sine, u); }, [=](Real c) { return (c - least) / (1 - least); });
}

TEST_CASE("sphere_cone: a sphere far away loses no digits") {
    Random random(5);
    for (const Real sine : {1e-3, 1e-6, 1e-9, 1e-12}) {
        Real mean = 0;
        for (int i = 0; i < 10000; ++i) {
            const DirectionSample sample = sphere_cone(sine, random.point());
            INFO("sine " << sine << ", direction " << text(sample.direction) << ", density " << sample.density);
            const Real share = (sqr(sample.direction.x) + sqr(sample.direction.y)) / (sine * sine);  // of the cone
            CHECK(share <= 1 + 1e-12);
            CHECK(sample.density * pi * sine * sine == Approx(1).epsilon(1e-6));
            mean += share / 10000;
        }
        CHECK(mean == Approx(0.5).margin(0.02));
    }
}

TEST_CASE("scatter_direction: density, distribution, corners of the square; mean cosine g") {
    const Real g = GENERATE(-0.9, -0.3, 0.0, 0.5, 0.95);
    INFO("g " << g);
    check_warp(
        [=](vec2 u) {
            return scatter_direction({0, 0, 1}, g, u);
        },
        [=](Real c) {
            if (g == 0) return (c + 1) / 2;
            return (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * c) - 1 / (1 + g));
        });
    Random random(6);
    for (int i = 0; i < 20; ++i) {
        const vec3 d = random.direction();
        const Real cosine = square_mean(300, [=](vec2 u) { return dot(scatter_direction(d, g, u).direction, d); });
        INFO("d " << text(d));
        CHECK(cosine == Approx(g).margin(1e-3));
    }
}
