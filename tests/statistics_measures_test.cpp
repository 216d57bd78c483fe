#include <algorithm>
#include <random>
#include <vector>

#include "catch.h"
#include "statistics/blob.h"
#include "statistics/image_fault.h"
#include "statistics/region.h"
#include "statistics/spread.h"
#include "statistics/tiles.h"

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
                image.at(x, y) +=
                    Color(f(x + (i % grid + 0.5) / grid, y + (i / grid + 0.5) / grid)) / double(grid * grid);
    return image;
}

}  // namespace

TEST_CASE("a region's mean is the mean of its pixels alone") {
    const Image image = film(8, 6, [](double x, double) { return x < 4 ? 1.0 : 3.0; });
    CHECK(region_mean(image, {2, 1, 4, 3}).y == Approx(2));
    CHECK(column_profile(image, whole(image))[3] == Approx(1));
    const Image stairs = film(8, 6, [](double x, double y) { return std::floor(y) + (x < 4 ? 0.0 : 10.0); });
    CHECK(column_profile(stairs, {3, 2, 2, 3}) == std::vector<double>{3, 13});
}

TEST_CASE("a slanted edge through box-filtered pixels has mean 0 and mean square (1 + slope^2) / 12") {
    const Edge edge{9.3, 0.125};
    const auto step = [&](double shift) {
        return film(
            20, 16, [&](double x, double y) { return x > edge.offset + edge.slope * y + shift ? 5.0 : 2.0; }, 64);
    };
    const SlantedSpread sharp = slanted_spread(step(0), {0, 0, 20, 16}, edge, 2, 5);
    CHECK(sharp.mean == Approx(0).margin(2e-3));
    CHECK(sharp.mean_square == Approx((1 + 0.125 * 0.125) / 12).epsilon(0.02));
    CHECK(slanted_spread(step(0.5), {0, 0, 20, 16}, edge, 2, 5).mean == Approx(0.5).epsilon(0.01));
    const Image level = transposed(step(0));
    CHECK(level.width == 16);
    CHECK(level.at(3, 7) == step(0).at(7, 3));
    CHECK(slanted_spread(transposed(level), {0, 0, 20, 16}, edge, 2, 5).mean == Approx(sharp.mean));
}

TEST_CASE("without a filter the spread of a slanted edge is 0") {
    const Edge edge{9.3, 0.125};
    const Image image = film(
        20, 16, [&](double x, double y) { return x > edge.offset + edge.slope * y ? 1.0 : 0.0; }, 1);
    CHECK(slanted_spread(image, {0, 0, 20, 16}, edge, 0, 1).mean_square == Approx(0).margin(3e-3));
}

TEST_CASE("the spread of a ramp is that of the uniform distribution") {
    const double width = 12;
    const Image image = film(40, 2, [&](double x, double) { return std::clamp((x - 13.5) / width, 0.0, 1.0); });
    const Spread s = edge_spread(column_profile(image, whole(image)));
    CHECK(s.mean == Approx(19.5));
    CHECK(s.variance == Approx(width * width / 12 + 1.0 / 6).epsilon(0.01));
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
    CHECK(disc.radial_square == Approx(radius * radius / 2).epsilon(0.01));
    CHECK(disc.radial_kurtosis == Approx(4.0 / 3).epsilon(0.01));
    CHECK(disc.covariance == Approx(0).margin(0.05));

    const Blob square =
        measure([&](double x, double y) { return std::max(std::abs(x), std::abs(y)) < radius ? 1.0 : 0.0; });
    CHECK(square.variance.y / (radius * radius) == Approx(1.0 / 3).epsilon(0.01));
    CHECK(square.radial_kurtosis == Approx(1.4).epsilon(0.01));

    const Blob peaked = measure([&](double x, double y) {
        const double r = std::hypot(x, y);
        return r < radius && r > 0 ? 1 / r : 0.0;
    });
    CHECK(peaked.variance.x / (radius * radius) == Approx(1.0 / 6).epsilon(0.02));
    CHECK(peaked.radial_kurtosis == Approx(1.8).epsilon(0.02));
}

TEST_CASE("what is no image is named, with the pixel") {
    Image image(4, 3);
    CHECK(!image_fault(image, 4, 3));
    CHECK(image_fault(image, 3, 4)->words == "the image has 4 x 3 pixels; expected 3 x 4");
    image.at(2, 1).y = NAN;
    CHECK(image_fault(image, 4, 3).value().words.find("pixel (2, 1), channel G, is not a number") == 0);
    image.at(2, 1).y = INFINITY;
    CHECK(image_fault(image, 4, 3).value().words.find("pixel (2, 1), channel G, is infinite") == 0);
    image.at(2, 1).y = -1e-9;
    CHECK(image_fault(image, 4, 3).value().words.find("pixel (2, 1), channel G, is negative") == 0);
    CHECK(image_fault(image, 4, 3)->verdict == Verdict::failed);
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

TEST_CASE("the tile where two pictures differ beyond noise is the clearest one") {
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(1, 0.1);
    const auto pictures = [&](double more) {
        std::vector<Image> all;
        for (int i = 0; i < 4; ++i) {
            all.emplace_back(20, 16);
            for (Color& pixel : all.back().pixels) pixel = Color(noise(random));
            for (int y = 8; y < 16; ++y)
                for (int x = 8; x < 16; ++x) all.back().at(x, y) += Color(more);
        }
        return all;
    };
    const auto right = pictures(0);
    const Tiles tiles = compare_tiles(pictures(0.5), right);
    CHECK(tiles.columns == 3);
    CHECK(tiles.rows == 2);
    CHECK(tiles.clearest() == 4);
    CHECK(tiles.p[4] < 1e-4);
    CHECK(std::abs(tiles.mine[4] - tiles.right[4] - 0.5) < 0.05);
    CHECK(tiles.p[0] > 1e-3);
    // without noise, of what differs the tile that differs most
    const Tiles same = compare_tiles({right[0]}, {right[0]});
    CHECK(same.t[same.clearest()] == 0);
    CHECK(compare_tiles({}, {}).empty());
}
