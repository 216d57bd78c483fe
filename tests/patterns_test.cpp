#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "catch.h"
#include "rt/sampler.h"

using namespace rt;

namespace {

/// All n points of one pair of dimensions.
template <Sampler sampler>
std::vector<vec2> points(Bits key, int n, int pair) {
    std::vector<vec2> all;
    for (int i = 0; i < n; ++i) all.push_back(pattern_2d<sampler>(key, i, n, Dimension(Bits(pair), pair, n)));
    return all;
}

/// Whether there is one value in each of columns x rows cells of the unit square.
bool one_in_each_cell(const std::vector<Real>& x, const std::vector<Real>& y, int columns, int rows) {
    std::vector<char> taken(std::size_t(columns) * std::size_t(rows), 0);
    for (std::size_t i = 0; i < x.size(); ++i) {
        char& cell = taken[std::size_t(int(x[i] * columns)) * std::size_t(rows) + std::size_t(int(y[i] * rows))];
        if (cell) return false;
        cell = 1;
    }
    return x.size() == taken.size();
}

std::vector<Real> coordinate(const std::vector<vec2>& points, int axis) {
    std::vector<Real> all;
    for (const vec2 p : points) all.push_back(p[axis]);
    return all;
}

template <Sampler sampler>
void check_nets() {
    for (int m = 0; m <= 12; ++m) {
        const int n = 1 << m;
        if (pattern_of(sampler, n) != sampler) continue;
        for (const int pair : {0, 1, 3, 40}) {
            const auto all = points<sampler>(77, n, pair);
            for (int k = 0; k <= m; ++k) {
                CAPTURE(m, pair, k);
                CHECK(one_in_each_cell(coordinate(all, 0), coordinate(all, 1), 1 << k, 1 << (m - k)));
            }
        }
    }
}

}  // namespace

TEST_CASE("each pair of dimensions has one sample in every elementary interval") {
    check_nets<Sampler::sobol>();
    check_nets<Sampler::orthogonal>();
}

TEST_CASE("any two dimensions of an orthogonal array have one sample in each cell") {
    for (int h = 1; h <= 4; ++h) {
        const int n = 1 << (2 * h), pairs = 1 << (h - 1);
        std::vector<std::vector<Real>> dimensions;
        for (int pair = 0; pair < pairs; ++pair)
            for (int axis = 0; axis < 2; ++axis)
                dimensions.push_back(coordinate(points<Sampler::orthogonal>(5, n, pair), axis));
        for (std::size_t a = 0; a < dimensions.size(); ++a)
            for (std::size_t b = a + 1; b < dimensions.size(); ++b) {
                CAPTURE(n, a, b);
                CHECK(one_in_each_cell(dimensions[a], dimensions[b], 1 << h, 1 << h));
            }
    }
}

TEST_CASE("scrambled points are uniform, and pairs do not go together") {
    // Over many keys: the first two moments of a sample, and its product with one of another pair, also of a later
    // array.
    constexpr int keys = 200'000, n = 16;
    const Dimension first(0, 0, n);
    for (const int pair : {1, 2, 9}) {
        const Dimension other(Bits(pair), pair, n);
        for (const int i : {0, 7}) {
            Real mean = 0, square = 0, product = 0, within = 0;
            for (int k = 0; k < keys; ++k) {
                const vec2 p = pattern_2d<Sampler::orthogonal>(combine(3, Bits(k)), i, n, first);
                const vec2 q = pattern_2d<Sampler::orthogonal>(combine(3, Bits(k)), i, n, other);
                mean += q.x / keys, square += q.x * q.x / keys;
                product += (p.x - 0.5) * (q.y - 0.5) / keys, within += (q.x - 0.5) * (q.y - 0.5) / keys;
            }
            CAPTURE(pair, i);
            CHECK(std::abs(mean - 1 / 2.) < 4.5 * std::sqrt(1 / 12. / keys));
            CHECK(std::abs(square - 1 / 3.) < 4.5 * std::sqrt(4 / 45. / keys));
            CHECK(std::abs(product) < 4.5 / 12. / std::sqrt(keys));
            CHECK(std::abs(within) < 4.5 / 12. / std::sqrt(keys));
        }
    }
}

TEST_CASE(
    "dimensions of one orthogonal array leave a fifth of the noise of random pairs, those of two no more than these") {
    // The variance of a mean of products over dimensions of two arrays.
    constexpr int n = 64, keys = 4000;
    for (const int pair : {1, 5, 9}) {
        Real variance = 0;
        for (int k = 0; k < keys; ++k) {
            const Bits key = combine(9, Bits(k));
            const auto a = points<Sampler::orthogonal>(key, n, 0), b = points<Sampler::orthogonal>(key, n, pair);
            Real mean = 0;
            for (std::size_t i = 0; i < n; ++i) mean += (a[i].x - 0.5) * (b[i].x - 0.5) / n;
            variance += mean * mean / keys;
        }
        CAPTURE(pair);
        const Real random = 1 / 144. / n;
        CHECK(variance < (pair < 4 ? 0.2 : 1.15) * random);
    }
}

namespace {

/// The variance, over many keys, of a mean to which two dimensions of different pairs contribute together.
template <Sampler sampler>
Real variance_of_mean(int n) {
    constexpr int keys = 2000;
    Real sum = 0, squares = 0;
    for (Bits key = 0; key < keys; ++key) {
        const auto a = points<sampler>(key, n, 0), b = points<sampler>(key, n, 1);
        Real mean = 0;
        for (std::size_t i = 0; i < a.size(); ++i)
            mean += ((a[i].x + b[i].x < 0.7) + (a[i].y * b[i].y < 0.3)) / Real(n);
        sum += mean, squares += sqr(mean);
    }
    return squares / keys - sqr(sum / keys);
}

}  // namespace

TEST_CASE("an orthogonal array is taken where it leaves less noise than Sobol's pairs") {
    for (int n = 4; n <= 256; n *= 4) {
        CAPTURE(n);
        CHECK(pattern_of(Sampler::orthogonal, n) == Sampler::orthogonal);
        CHECK(variance_of_mean<Sampler::orthogonal>(n) < variance_of_mean<Sampler::sobol>(n));
    }
}

TEST_CASE("an orthogonal array takes a power of four, up to 256, and others are Sobol's points") {
    CHECK(pattern_of(Sampler::orthogonal, 1) == Sampler::orthogonal);
    CHECK(pattern_of(Sampler::orthogonal, 256) == Sampler::orthogonal);
    CHECK(pattern_of(Sampler::orthogonal, 1024) == Sampler::sobol);
    CHECK(pattern_of(Sampler::orthogonal, 48) == Sampler::sobol);
    CHECK(pattern_of(Sampler::orthogonal, 128) == Sampler::sobol);
    CHECK(pattern_of(Sampler::stratified, 48) == Sampler::stratified);
    for (std::size_t i = 0; i < sampler_names.size(); ++i) CHECK(sampler_named(sampler_names[i]) == Sampler(i));
    CHECK(!sampler_named("halton"));
}

namespace {

/// How many times smaller the squared error of an image of means is, once blocks of 2 x 2 and of 4 x 4 pixels are
/// averaged.
template <Sampler sampler>
std::array<Real, 2> gain_of_blocks(int n) {
    constexpr int width = 64;
    std::array<Real, 3> squares{};
    for (Bits seed = 0; seed < 8; ++seed)
        for (int level = 0; level < 3; ++level) {
            const int block = 1 << level;
            for (int y = 0; y < width; y += block)
                for (int x = 0; x < width; x += block) {
                    Real error = 0;
                    for (int k = 0; k < block * block; ++k) {
                        const Bits key = pixel_key(seed, width, x + k % block, y + k / block, sampler);
                        for (int i = 0; i < n; ++i) {
                            const vec2 p = pattern_2d<sampler>(key, i, n, Dimension(3));
                            error += (p.x * p.y + std::cos(2 * p.x) - 0.25 - std::sin(2.) / 2) / n / block / block;
                        }
                    }
                    squares[std::size_t(level)] += sqr(error) * block * block;
                }
        }
    return {squares[0] / squares[1], squares[1] / squares[2]};
}

}  // namespace

TEST_CASE("blue noise: the errors of neighbours cancel, those of other patterns are independent") {
    for (const int n : {1, 4, 16}) {
        const auto blue = gain_of_blocks<Sampler::blue_noise>(n), sobol = gain_of_blocks<Sampler::sobol>(n);
        CAPTURE(n, blue[0], blue[1], sobol[0], sobol[1]);
        for (const Real gain : blue) CHECK(gain > 8);
        for (const Real gain : sobol) CHECK(std::abs(gain - 4) < 0.6);
    }
}

TEST_CASE("blue noise: each pixel's samples are a net, of its own, and a branch has other numbers") {
    const int n = 16;
    std::set<std::pair<Real, Real>> seen;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            for (const bool branch : {false, true}) {
                const Bits pixel = pixel_key(5, 8, x, y, Sampler::blue_noise);
                const Bits key = branch ? branch_key(pixel, Sampler::blue_noise) : pixel;
                std::vector<vec2> all;
                for (int i = 0; i < n; ++i) all.push_back(pattern_2d<Sampler::blue_noise>(key, i, n, Dimension(2)));
                for (const vec2 p : all) seen.emplace(p.x, p.y);
                CHECK(one_in_each_cell(coordinate(all, 0), coordinate(all, 1), 4, 4));
            }
    CHECK(seen.size() == 8u * 8 * 2 * 16);
}
