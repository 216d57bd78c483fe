#include "asked/film_sample.h"
#include "checks/film_sample/checks.h"
#include "checks/kit/convergence.h"
#include "checks/kit/kit.h"
#include "checks/kit/own_numbers.h"
#include "statistics/moments.h"

namespace grade {

namespace {

using rt::Extent, rt::FilmSample, rt::vec2;

constexpr int pixels = 64;

/// Where in its pixel a sample falls, 0 to 1.
vec2 place_in_pixel(const Row& in, const Row& out) {
    const Extent pixel = argument<rt::film_sample, 0>(in);
    return (result<rt::film_sample>(out).position - pixel.low) / (pixel.high - pixel.low);
}

Extent any_pixel(Generator& draws) {
    const vec2 low(whole_between(draws, 0, 300), whole_between(draws, 0, 300));
    const double width = between(draws, 0.5, 2), height = between(draws, 0.5, 2);
    return {low, low + vec2(width, height)};
}

/// Red, green and blue stripes, one of each to a row of pixels: a sample sees one of the colours, each as often, in
/// every pixel.
Check fine_stripes(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(16, 16);
    const bool across = chance(random, 0.5);
    const double start = between(random, 0, 1);
    std::string scene = toml(film_view(place, size));
    for (int c = 0; c < 3; ++c) {
        const char* colors[] = {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"};
        scene += unsampled_lamp(fmt::format("stripe{}", c), colors[c]);
    }
    for (int k = -3; k < 3 * size.y; ++k) {
        const double middle = start + (k + 0.5) / 3;
        const vec2 center = across ? vec2(middle, 8) : vec2(8, middle), u = across ? vec2(1.0 / 6, 0) : vec2(20, 0);
        scene += bright(place, size, fmt::format("stripe{}", (k + 3) % 3), center, u,
                        across ? vec2(0, 20) : vec2(0, 1.0 / 6));
    }
    return render_check("fine_stripes", {scene, 1, "random"},
                        {own_numbers({0, 0, size.x, size.y}, 1, "position in the pixel", "the middle")});
}

/// Of a sample, with its weight, the power of its distance from the middle of the pixel along an axis.
auto moment(int axis, int power) {
    return [=](const Row& in, const Row& out) {
        return result<rt::film_sample>(out).weight * std::pow(place_in_pixel(in, out)[axis] - 0.5, power);
    };
}

std::vector<Statistic> means_about_the_middle() {
    std::vector<Statistic> statistics;
    for (const int axis : {0, 1})
        statistics.push_back(mean_of(
            {.id = "A1",
             .what = fmt::format("mean {}, from the middle of the pixel [pixel]", "xy"[axis]),
             .number = moment(axis, 1),
             .truth = 0,
             .unit = 0.2,
             .hint = [](double value, double) -> std::string {
                 if (std::abs(std::abs(value) - 0.5) < 0.1) return "the picture is shifted by half a pixel";
                 return "samples are not spread evenly about the middle of the pixel: is a stratum computed by integer "
                        "division?";
             }}));
    return statistics;
}

/// All samples of some pixels, whose extents are anywhere and of any size: the mean of the weights and, weighted, the
/// first and the second moment of each axis about the middle.
Check even_in_the_pixel(int n, const std::function<Rows(Generator&)>& inputs) {
    std::vector<Statistic> statistics = {
        mean_of({.id = "A1",
                 .what = "mean weight",
                 .number = moment(0, 0),
                 .hint = by_ratio("the mean weight", {{1.0 / n, "the framework divides by the number of samples"},
                                                      {double(n), "a sample counts as 1, not as n"}})})};
    for (Statistic& mean : means_about_the_middle()) statistics.push_back(std::move(mean));
    for (const int axis : {0, 1})
        statistics.push_back(mean_of({.id = "A1",
                                      .what = fmt::format("variance of {} [pixel^2]", "xy"[axis]),
                                      .number = moment(axis, 2),
                                      .truth = 1.0 / 12,
                                      .hint = by_ratio("the variance of the samples in a pixel",
                                                       {{0, "all samples are at one point: edges stay jagged"},
                                                        {4, "the samples spread over two pixels"},
                                                        {0.25, "the samples fill half of the pixel's width"}})}));
    // stratified points are more even than random ones
    statistics.push_back(uniform_in_square({.id = "A1",
                                            .what = "chi-squared of equal parts of the pixel",
                                            .point = place_in_pixel,
                                            .columns = 4,
                                            .rows = 4,
                                            .delta0 = 1,
                                            .delta = 1.5,
                                            .hint = always("the samples do not fill the pixel evenly")}));
    statistics.push_back(purity());
    return probe_check("even_in_the_pixel", inputs, statistics);
}

/// n Var(mean of the pixel's x) / (1/12) is 1 for independent samples, and 1/n for cells of a grid.
Statistic dispersion_of_mean(int n) {
    return {.id = "G2",
            .what = "dispersion of a pixel's mean position",
            .measure =
                [n](const Observation& seen) {
                    double square_sum = 0;
                    for (int k = 0; k < pixels; ++k) {
                        vec2 sum(0);
                        for (int i = 0; i < n; ++i)
                            sum += place_in_pixel(seen.inputs[k * n + i], seen.outputs[k * n + i]) - 0.5;
                        square_sum += rt::dot(sum, sum) / n / 2;
                    }
                    return 12 * square_sum / pixels;
                },
            .truth = 1.0 / n,
            .delta0 = 0.35,
            .delta = 0.6,
            .hint = [](double value, double truth) -> std::string {
                if (value > 0.8 && value < 1.2)
                    return "the samples are independent: each must fall in a cell of its own, see stratified_2d";
                return value > truth ? "the samples of a pixel move together: is one position drawn for all of them?"
                                     : "the samples hardly move from render to render: is u used?";
            }};
}

/// One sample moves in a cell of 1/n of the pixel: n 12 Var(x) is 1, and the same for y.
Statistic variance_of_sample(int n) {
    return {.id = "G2",
            .what = "variance of one sample, over that of a cell",
            .measure =
                [n](const Observation& seen) {
                    double variance = 0;
                    for (int i = 0; i < n; ++i) {
                        Moments x, y;
                        for (int k = 0; k < pixels; ++k) {
                            const vec2 s = place_in_pixel(seen.inputs[k * n + i], seen.outputs[k * n + i]);
                            x.add(s.x), y.add(s.y);
                        }
                        variance += (x.variance() + y.variance()) / 2 / n;
                    }
                    return 12 * n * variance;
                },
            .truth = 1,
            .delta0 = 0.05,
            .delta = 0.5,
            .hint =
                [n](double value, double) {
                    if (value < 0.1)
                        return fmt::format(
                            "with new random numbers a sample hardly moves, by {:.3g} of its cell's "
                            "variance: is u, its jitter, ignored, drawn once, or the same in all pixels?",
                            value);
                    const double cells = n / value;
                    if (cells < 1.2)
                        return std::string(
                            "each sample falls anywhere in the pixel: it must fall in a cell of its own, "
                            "see stratified_2d");
                    return fmt::format("a sample moves as if the pixel had {:.3g} cells; expected n = {}", cells, n);
                }};
}

Statistic inside_the_pixel() {
    return property({.id = "A1",
                     .what = "distance outside the pixel, in its size",
                     .violation =
                         [](const Row& in, const Row& out) {
                             const vec2 s = place_in_pixel(in, out);
                             return std::max({0.0, -s.x, -s.y, s.x - 1, s.y - 1});
                         },
                     .tolerance = 1e-5,
                     .says = "samples fall outside the pixel: it covers low <= x < high"});
}

/// A single sample of a pixel: its two coordinates must not go together.
Check single_sample() {
    const auto single = rows_over_square(24, [](vec2 u) { return row(Extent{vec2(3, 5), vec2(4, 6)}, 0, 1, u); });
    const Statistic together =
        mean_of({.id = "A1",
                 .what = "covariance of the two coordinates of a single sample, over their variance",
                 .number =
                     [](const Row& in, const Row& out) {
                         const vec2 s = place_in_pixel(in, out) - 0.5;
                         return 12 * s.x * s.y;
                     },
                 .truth = 0,
                 .delta0 = 0.02,
                 .delta = 0.2,
                 .hint = always("x and y of a sample go together: each needs a coordinate of u of its own")});
    return probe_check("single_sample", single, {together});
}

}  // namespace

Checks check_film_sample(Generator& random) {
    const int n = std::array{12, 20, 30}[whole_between(random, 0, 2)];  // no square: there too each has its cell
    const auto inputs = with_repeats([n](Generator& draws) {
        Rows rows;
        for (int k = 0; k < pixels; ++k) {
            const Extent pixel = any_pixel(draws);
            for (int i = 0; i < n; ++i) rows.push_back(row(pixel, i, n, square(draws)));
        }
        return rows;
    });
    // cells of equal area do not form a square then
    const auto any_number = with_repeats([](Generator& draws) {
        Rows rows;
        for (const int count : {2, 3, 5, 6, 7, 8, 12, 18})
            for (int k = 0; k < 8; ++k) {
                const Extent pixel = any_pixel(draws);
                for (int i = 0; i < count; ++i) rows.push_back(row(pixel, i, count, square(draws)));
            }
        return rows;
    });
    const auto ends = rows_of(96, [](Generator& draws) {  // of large pictures as well
        Extent pixel = any_pixel(draws);
        const vec2 right_and_down(whole_between(draws, 0, 4000), whole_between(draws, 0, 4000));
        pixel.low += right_and_down, pixel.high += right_and_down;
        const int count = whole_between(draws, 1, 6), i = whole_between(draws, 0, count - 1);
        return row(pixel, i, count, end_of_square(draws));
    });
    // one pixel, drawn again and again: only u changes
    const auto one_pixel = [n](Generator& draws) {
        const Extent pixel = any_pixel(draws);
        Rows rows;
        for (int k = 0; k < pixels; ++k)
            for (int i = 0; i < n; ++i) rows.push_back(row(pixel, i, n, square(draws)));
        return rows;
    };
    const SamplesOfASquare samples{
        [](vec2 low, int i, int n, vec2 u) {
            return row(Extent{low, low + 1.0}, i, n, u);
        },
        [](const Row& in, const Row& out) {
            return SamplesOfASquare::Sample{place_in_pixel(in, out), result<rt::film_sample>(out).weight};
        }};
    std::vector<Statistic> of_any_number = means_about_the_middle();
    of_any_number.insert(of_any_number.begin(), inside_the_pixel());
    return {probe_check("in_the_pixel", rows_then(inputs, ends), {inside_the_pixel()}),
            probe_check("any_number_of_samples", any_number, of_any_number),
            single_sample(),
            probe_check("stratified", one_pixel, {variance_of_sample(n), dispersion_of_mean(n)}),
            even_in_the_pixel(n, inputs),
            film_sample::slanted_edges(random),
            fine_stripes(random),
            error_orders(random, samples),
            rings(random, samples),
            film_sample::horizon(random)};
}

}  // namespace grade
