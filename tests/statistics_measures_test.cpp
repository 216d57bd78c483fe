#include <random>
#include <vector>

#include "catch.h"
#include "statistics/blob.h"
#include "statistics/image_fault.h"
#include "statistics/noise.h"
#include "statistics/region.h"
#include "statistics/spread.h"

using namespace grade;
using rt::Color;
using rt::Image;

namespace {

/// Pixels that are means of `grid`^2 points of a function of the film point.
template <class F>
Image film(int width, int height, F&& f, int grid = 16) {
    Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int i = 0; i < grid * grid; ++i)
                image.at(x, y) += Color(f(x + (i % grid + 0.5) / grid, y + (i / grid + 0.5) / grid)) / double(grid * grid);
    return image;
}

}  // namespace

TEST_CASE("a region's mean is the mean of its pixels alone") {
    const Image image = film(8, 6, [](double x, double) { return x < 4 ? 1.0 : 3.0; });
    CHECK(region_mean(image, {2, 1, 4, 3}).y == Approx(2));
    CHECK(column_profile(image, whole(image))[3] == Approx(1));
    CHECK(row_profile(image, {4, 0, 4, 6}).size() == 6);
}

TEST_CASE("a slanted edge through box-filtered pixels has mean 0 and mean square (1 + slope^2) / 12") {
    const Edge edge{9.3, 0.125};
    const auto step = [&](double shift) {
        return film(20, 16, [&](double x, double y) { return x > edge.offset + edge.slope * y + shift ? 5.0 : 2.0; }, 64);
    };
    const SlantedSpread sharp = slanted_spread(step(0), {0, 0, 20, 16}, edge, 2, 5);
    CHECK(sharp.mean == Approx(0).margin(2e-3));
    CHECK(sharp.mean_square == Approx((1 + 0.125 * 0.125) / 12).epsilon(0.02));
    CHECK(slanted_spread(step(0.5), {0, 0, 20, 16}, edge, 2, 5).mean == Approx(0.5).epsilon(0.01));
    CHECK(slanted_spread(transposed(transposed(step(0))), {0, 0, 20, 16}, edge, 2, 5).mean == Approx(sharp.mean));
}

TEST_CASE("without a filter the spread of a slanted edge is 0") {
    const Edge edge{9.3, 0.125};
    const Image image = film(20, 16, [&](double x, double y) { return x > edge.offset + edge.slope * y ? 1.0 : 0.0; }, 1);
    CHECK(slanted_spread(image, {0, 0, 20, 16}, edge, 0, 1).mean_square == Approx(0).margin(3e-3));
}

TEST_CASE("the spread of a ramp is that of the uniform distribution") {
    const double width = 12;
    const Image image = film(40, 2, [&](double x, double) { return std::clamp((x - 13.5) / width, 0.0, 1.0); });
    const Spread s = edge_spread(column_profile(image, whole(image)));
    CHECK(s.mean == Approx(19.5));
    CHECK(s.variance == Approx(width * width / 12 + 1.0 / 6).epsilon(0.01));
    CHECK(s.kurtosis == Approx(1.8).epsilon(0.02));
}

TEST_CASE("a uniform streak has variance L^2/12 and kurtosis 1.8, two end points have kurtosis 1") {
    const Image streak = film(40, 3, [](double x, double) { return x > 10 && x < 30 ? 1.0 : 0.0; });
    const Spread s = light_spread(column_profile(streak, whole(streak)));
    CHECK(s.mean == Approx(20));
    CHECK(s.variance == Approx(400.0 / 12).epsilon(0.01));
    CHECK(s.kurtosis == Approx(1.8).epsilon(0.01));
    std::vector<double> ends(40, 0);
    ends[10] = ends[30] = 1;
    CHECK(light_spread(ends).kurtosis == Approx(1));
}

TEST_CASE("blobs: disc, square, and disc without its square root have the shapes that tell them apart") {
    const double radius = 12;
    const auto measure = [&](auto density) {
        const Image image = film(40, 40, [&](double x, double y) { return density(x - 20.25, y - 19.5); });
        return blob_moments(image, whole(image));
    };
    const Blob disc = measure([&](double x, double y) { return std::hypot(x, y) < radius ? 1.0 : 0.0; });
    CHECK(disc.centroid.x == Approx(20.25).epsilon(1e-3));
    CHECK(disc.centroid.y == Approx(19.5).epsilon(1e-3));
    CHECK(disc.variance.x / (radius * radius) == Approx(0.25).epsilon(0.01));
    CHECK(disc.kurtosis.x == Approx(2).epsilon(0.01));
    CHECK(disc.radial_square == Approx(radius * radius / 2).epsilon(0.01));
    CHECK(disc.radial_kurtosis == Approx(4.0 / 3).epsilon(0.01));
    CHECK(disc.covariance == Approx(0).margin(0.05));

    const Blob square = measure([&](double x, double y) { return std::max(std::abs(x), std::abs(y)) < radius ? 1.0 : 0.0; });
    CHECK(square.variance.y / (radius * radius) == Approx(1.0 / 3).epsilon(0.01));
    CHECK(square.kurtosis.y == Approx(1.8).epsilon(0.01));

    const Blob peaked = measure([&](double x, double y) {
        const double r = std::hypot(x, y);
        return r < radius && r > 0 ? 1 / r : 0.0;
    });
    CHECK(peaked.variance.x / (radius * radius) == Approx(1.0 / 6).epsilon(0.02));
    CHECK(peaked.kurtosis.x == Approx(2.7).epsilon(0.02));
}

TEST_CASE("the design effect is 1 for pixels of their own, and counts the pixels that share numbers") {
    std::mt19937_64 random(1);
    std::normal_distribution<double> noise(1, 0.1);
    std::vector<Image> own, rows, all;
    for (int k = 0; k < 64; ++k) {
        Image a(8, 4), b(8, 4), c(8, 4);
        const Color shared(noise(random));
        for (int y = 0; y < 4; ++y) {
            const Color row(noise(random));
            for (int x = 0; x < 8; ++x) a.at(x, y) = Color(noise(random)), b.at(x, y) = row, c.at(x, y) = shared;
        }
        own.push_back(a), rows.push_back(b), all.push_back(c);
    }
    CHECK(design_effect(own, {0, 0, 8, 4}) == Approx(1).margin(0.7));
    CHECK(design_effect(rows, {0, 0, 8, 4}) == Approx(8).margin(4));
    CHECK(design_effect(all, {0, 0, 8, 4}) == Approx(32));
    CHECK(noise_level(own, {0, 0, 8, 4}) == Approx(0.1).epsilon(0.1));
}

TEST_CASE("the dispersion is 1 for independent samples and 2/3 for four jittered ones and an edge through their left half") {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> u(0, 1);
    const auto replicate = [&](bool jittered) {
        Image image(64, 1);
        for (Color& pixel : image.pixels)
            for (int i = 0; i < 4; ++i) {
                const double x = jittered ? (i % 2 + u(random)) / 2 : u(random);
                // two samples in the left half, each of them left of the edge in half of the cases:
                // variance 2 (1/4) (1/4)^2 = 1/32, p (1 - p) = 3/16
                if (x < 0.25) pixel += Color(0.25);
            }
        return image;
    };
    std::vector<Image> independent, jittered;
    for (int k = 0; k < 400; ++k) independent.push_back(replicate(false)), jittered.push_back(replicate(true));
    CHECK(dispersion(independent, {0, 0, 64, 1}, 4) == Approx(1).epsilon(0.05));
    CHECK(dispersion(jittered, {0, 0, 64, 1}, 4) == Approx(2.0 / 3).epsilon(0.05));
}

TEST_CASE("what is no image is named, with the pixel") {
    Image image(4, 3);
    CHECK(!image_fault(image, 4, 3));
    CHECK(image_fault(image, 3, 4) == "the image has 4 x 3 pixels; expected 3 x 4");
    image.at(2, 1).y = NAN;
    CHECK(image_fault(image, 4, 3).value().find("pixel (2, 1), channel G, is not a number") == 0);
    image.at(2, 1).y = INFINITY;
    CHECK(image_fault(image, 4, 3).value().find("pixel (2, 1), channel G, is infinite") == 0);
    image.at(2, 1).y = -1e-9;
    CHECK(image_fault(image, 4, 3).value().find("pixel (2, 1), channel G, is negative") == 0);
}

TEST_CASE("an 8-bit picture is recognised, a float one and a flat one are not") {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> u(0, 1);
    Image real(16, 16), linear(16, 16), srgb(16, 16);
    for (int k = 0; k < 256; ++k) {
        const double x = u(random), level = std::round(255 * x) / 255;
        real.pixels[k] = Color(x);
        linear.pixels[k] = Color(level);
        srgb.pixels[k] = Color(level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4));
    }
    CHECK(!is_quantised(real));
    CHECK(is_quantised(linear));
    CHECK(is_quantised(srgb));
    CHECK(!is_quantised(Image(16, 16)));
    CHECK(is_same(real, real));
    CHECK(!is_same(real, linear));
}
