#include <functional>
#include <random>
#include <vector>

#include "catch.h"
#include "statistics/blob.h"
#include "statistics/closed_forms.h"
#include "statistics/moments.h"
#include "statistics/regression.h"
#include "statistics/sharing.h"

using namespace grade;
using rt::Color;
using rt::Image;

namespace {

std::mt19937_64 engine(11);
double uniform() { return std::uniform_real_distribution<double>(0, 1)(engine); }

/// Each sample sees red, green or blue; number(x, y) is its random number.
template <class F>
Image three_colors(int size, int samples, F number) {
    Image image(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            for (int i = 0; i < samples; ++i) image.at(x, y)[std::min(2, int(3 * number(x, y, i)))] += 1.0 / samples;
    return image;
}

Moments over_images(int count, const std::function<double()>& number) {
    Moments all;
    for (int k = 0; k < count; ++k) all.add(number());
    return all;
}

}  // namespace

TEST_CASE("independent pixels share nothing, and vary within the image as independent samples do") {
    for (const int samples : {1, 4}) {
        const auto image = [&] { return three_colors(16, samples, [](int, int, int) { return uniform(); }); };
        CAPTURE(samples);
        const Moments shared = over_images(300, [&] { return sharing(image(), {0, 0, 16, 16}, samples).sum(); });
        CHECK(shared.mean == Approx(0).margin(4 * shared.standard_error() + 0.005));
        CHECK(shared.deviation() < 0.12);
        const Moments within = over_images(300, [&] { return within_variance(image(), {0, 0, 16, 16}, samples); });
        CHECK(within.mean == Approx(1).margin(4 * within.standard_error() + 0.005));
    }
}

TEST_CASE("one number for an image, for a row or for a column is named, and no division by zero follows") {
    const double once = uniform();
    const Sharing all = sharing(three_colors(16, 1, [&](int, int, int) { return once; }), {0, 0, 16, 16}, 1);
    CHECK(all.all == 1);
    CHECK(all.rows == 1);
    CHECK(all.columns == 1);
    std::vector<double> numbers(16);
    for (double& u : numbers) u = uniform();
    const Sharing rows =
        sharing(three_colors(16, 1, [&](int, int y, int) { return numbers[std::size_t(y)]; }), {0, 0, 16, 16}, 1);
    CHECK(rows.rows == Approx(1));
    CHECK(rows.columns < 0.2);
    const Sharing columns =
        sharing(three_colors(16, 1, [&](int x, int, int) { return numbers[std::size_t(x)]; }), {0, 0, 16, 16}, 1);
    CHECK(columns.columns == Approx(1));
    CHECK(columns.rows < 0.2);
    // one set of four samples for all pixels
    const Image same = three_colors(16, 4, [&](int, int, int i) { return numbers[std::size_t(i)]; });
    CHECK(sharing(same, {0, 0, 16, 16}, 4).all > 0.999);
    CHECK(within_variance(same, {0, 0, 16, 16}, 4) == Approx(0).margin(1e-12));
    // nothing to be seen says nothing
    CHECK(sharing(Image(16, 16), {0, 0, 16, 16}, 4).sum() == 0);
}

TEST_CASE("errors of known patterns fall with their known powers") {
    const auto slope = [](auto error) {
        Moments slopes;
        for (int k = 0; k < 40; ++k) {
            std::vector<double> counts, errors;
            for (const int n : levels(5)) {
                std::vector<double> off;
                for (int repeat = 0; repeat < 12; ++repeat) off.push_back(error(n));
                counts.push_back(n);
                errors.push_back(root_mean_square(off));
            }
            slopes.add(error_slope(counts, errors));
        }
        return slopes.mean;
    };
    const auto mean = [](int n, auto x) {
        double sum = 0;
        for (int i = 0; i < n; ++i) sum += x(i) / n;
        return sum;
    };
    CHECK(slope([&](int n) { return mean(n, [](int) { return uniform(); }) - 0.5; }) == Approx(-0.5).margin(0.03));
    CHECK(slope([&](int n) { return mean(n, [&](int i) { return (i + uniform()) / n; }) - 0.5; }) ==
          Approx(-1.5).margin(0.03));
    CHECK(slope([&](int n) {
              const int side = int(std::lround(std::sqrt(n)));
              return mean(n, [&](int i) { return (i % side + uniform()) / side + 2 * (i / side + uniform()) / side; }) -
                     1.5;
          }) == Approx(-1).margin(0.03));
    CHECK(slope([&](int n) {
              const int side = int(std::lround(std::sqrt(n)));
              return mean(n,
                          [&](int i) {
                              return (i % side + uniform()) / side + 0.6 * (i / side + uniform()) / side > 1 ? 1.0
                                                                                                             : 0.0;
                          }) -
                     0.3;
          }) == Approx(-0.75).margin(0.06));
    CHECK(slope([&](int n) { return mean(n, [&](int i) { return std::exp(-(i + 0.5) / n); }) - (1 - std::exp(-1)); }) ==
          Approx(-2).margin(0.02));
    CHECK(slope([&](int n) { return mean(n, [](int) { return uniform(); }) - 0.2; }) > -0.1);  // a bias
    CHECK(slope([](int) { return 0.0; }) == 0);
    CHECK(levels(4) == std::vector<int>{1, 4, 16, 64});
}

TEST_CASE(
    "a zone plate's mean over a pixel is that of many points, and regular points leave a bias that random ones do "
    "not") {
    const double rate = 4 * rt::pi / 200;
    for (const rt::vec2 low : {rt::vec2(3, 5), rt::vec2(120, 60), rt::vec2(190, 199)}) {
        double sum = 0;
        constexpr int grid = 400;
        for (int i = 0; i < grid * grid; ++i)
            sum += zone_plate(rate, low + (rt::vec2(i % grid, i / grid) + 0.5) / double(grid)) / grid / grid;
        CHECK(zone_plate_mean(rate, {low, low + 1.0}) == Approx(sum).margin(1e-4));
    }
    double jagged = 0, regular = 0;
    Moments random;
    for (int k = 0; k < 2000; ++k) {
        const rt::vec2 low(std::floor(185 + 30 * uniform()), std::floor(185 + 30 * uniform()));
        const double due = zone_plate_mean(rate, {low, low + 1.0});
        const auto estimate = [&](bool jitter) {
            double sum = 0;
            for (int i = 0; i < 16; ++i)
                sum += zone_plate(rate, low + (rt::vec2(i % 4, i / 4) +
                                               (jitter ? rt::vec2(uniform(), uniform()) : rt::vec2(0.5))) /
                                                  4.0) /
                       16;
            return sum;
        };
        jagged += rt::sqr(zone_plate(rate, low + 0.5) - due);
        regular += squared_bias(estimate(false), estimate(false), due);
        random.add(squared_bias(estimate(true), estimate(true), due));
    }
    CHECK(regular / jagged > 0.3);
    CHECK(random.mean / (jagged / 2000) == Approx(0).margin(0.02));
}

TEST_CASE("colours that go with the place have other moments, colours that do not have the same") {
    Image image(20, 20);
    const auto add = [&](rt::vec2 p, int channel) { image.at(int(p.x), int(p.y))[channel] += 1; };
    for (int k = 0; k < 20000; ++k) {
        const double r = 8 * std::sqrt(uniform()), turn = 2 * rt::pi * uniform();
        add({10 + r * std::cos(turn), 10 + r * std::sin(turn)}, uniform() < 0.5 ? 0 : 1);
    }
    const ColorMoments apart = color_moments(image, {0, 0, 20, 20}, {10, 10}, 8);
    CHECK(apart.centroid.x == Approx(0).margin(0.04));
    CHECK(apart.square == Approx(0).margin(0.04));
    Image sides(20, 20);
    for (int y = 2; y < 18; ++y)
        for (int x = 2; x < 18; ++x) sides.at(x, y)[x < 10] = 1;
    CHECK(color_moments(sides, {0, 0, 20, 20}, {10, 10}, 8).centroid.x == Approx(1));
    CHECK(color_moments(sides, {0, 0, 20, 20}, {10, 10}, 8).centroid.y == Approx(0).margin(1e-12));
}

TEST_CASE("variances of pixel, lens, time and lamp add, and light scatters 4/3 r s times in a ball") {
    Moments place, ways;
    for (int k = 0; k < 200000; ++k) {
        const auto on_disc = [&](double radius) {
            return radius * std::sqrt(uniform()) * std::cos(2 * rt::pi * uniform());
        };
        place.add(5 * uniform() + on_disc(2) + on_disc(0.7) + uniform());
        ways.add(2 *
                 std::sqrt(1 - uniform()));  // chords of the unit sphere, light from all sides alike: sin^2 is uniform
    }
    CHECK(streak_variance(5, 2, 0.7) == Approx(place.variance()).epsilon(0.01));
    CHECK(mean_scatterings(1, 1) == Approx(ways.mean).epsilon(0.01));
}
