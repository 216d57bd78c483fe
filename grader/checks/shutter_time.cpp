#include <algorithm>

#include "asked/shutter_time.h"
#include "checks/kit/own_density.h"
#include "checks/kit/own_numbers.h"
#include "statistics/sharing.h"

namespace grade {

namespace {

using rt::Shutter, rt::vec2, rt::vec3;

/// How much of the time that the shutter is open has passed.
double share_of_exposure(double time, const Shutter& shutter, double) {
    return (time - shutter.open) / (shutter.close - shutter.open);
}

/// What a wrong time may be, all of it.
std::string range_of_times(const Observation& seen, double open, double length) {
    const auto all_within = [&](double low, double high) {
        return std::ranges::all_of(seen.outputs,
                                   [&](const Row& out) { return out[0] >= low - 1e-6 && out[0] <= high + 1e-6; });
    };
    if (all_within(0, length)) return "times start at 0; expected open + a share of (close - open)";
    if (all_within(std::min(0.0, open + length), std::max(0.0, open + length)))
        return "times are a share of close; expected open + a share of (close - open)";
    if (all_within(open, open + 1) && !all_within(open, open + std::max(0.9, 1.1 * length)))
        return "up to a second is added to open, whatever close is; expected a share of (close - open)";
    return "";
}

std::string few_times(const Observation& seen) {
    double at_ends = 0, as_first = 0;
    for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
        const double s = of_call<rt::shutter_time>(share_of_exposure)(seen.inputs[k], seen.outputs[k]);
        at_ends += std::abs(s) < 1e-6 || std::abs(s - 1) < 1e-6;
        as_first += seen.outputs[k] == seen.outputs[0];
    }
    const double rows = double(seen.inputs.size());
    if (as_first == rows)
        return "there is one time for all samples, the same for every u: each sample has a time of its own";
    if (at_ends > 0.95 * rows) return "only the two end times occur, open and close: expected every time between them";
    return "";
}

/// All times of the exposure get equally many samples.
Check even() {
    const auto row_with = [](Generator& draw, vec2 u) {
        const double open = between(draw, -1, 1);
        return row(Shutter{open, open + log_between(draw, 0.01, 1)}, u.x);
    };
    return own_density(row_with, {of_call<rt::shutter_time>([](double time) { return vec3(time, 0, 0); }),
                                  of_call<rt::shutter_time>([](double, const Shutter& shutter, double) {
                                      return 1 / (shutter.close - shutter.open);
                                  }),
                                  "1/(close - open)", 1});
}

Check times(Generator& random) {
    const double open = between(random, 0.5, 2) * (chance(random, 0.5) ? 1 : -1), length = between(random, 0.2, 0.4);
    const auto inputs = rows_of(1024, [=](Generator& draw) {
        return row(Shutter{open, open + length}, between(draw, 0, 1));
    });
    Statistic inside = property({.id = "M1",
                                 .what = "times outside the exposure",
                                 .violation = of_call<rt::shutter_time>([](double time, const Shutter& s, double u) {
                                     const double share = share_of_exposure(time, s, u);
                                     return share >= -1e-5 && share <= 1 + 1e-5 ? 0.0 : 1.0;
                                 })});
    inside.hint =
        always("a time is before the shutter opens or after it closes: expected open + a share of (close - open)");
    // a range is no proof: told where nothing better is found
    inside.cause = [=](const Observation& seen) { return Shown("", range_of_times(seen, open, length)); };
    const Statistic mean =
        mean_of({.id = "M1",
                 .what = "mean time, as a share of the exposure",
                 .number = of_call<rt::shutter_time>(share_of_exposure),
                 .truth = 0.5,
                 .unit = 1,
                 .hint = by_value("the mean time, as a share of the exposure,",
                                  {{0, "does the shutter close as soon as it opens?"},
                                   {1, "does the shutter open only when it closes?"}},
                                  0.05, "expected times that are uniform between opening and closing"),
                 .cause = few_times});
    const Statistic spread = uniform_in_square(
        {.id = "V3",
         .what = "chi squared of the times per degree of freedom",
         .point = of_call<rt::shutter_time>(
             [](double time, const Shutter& s, double u) { return vec2(share_of_exposure(time, s, u), 0.5); }),
         .columns = 64,
         .rows = 1,
         .hint = by_ratio("the chi squared of the times", {}, "they must be uniform between opening and closing"),
         .cause = few_times});
    return probe_check("times", inputs, {inside, mean, spread});
}

Check instant() {
    const auto instants = rows_of(16, [](Generator& random) {
        const double open = between(random, -2, 2);
        return row(Shutter{open, open}, between(random, 0, 1));
    });
    const auto any_exposure = rows_of(256, [](Generator& random) {
        const double open = (chance(random, 0.5) ? 1 : -1) * log_between(random, 1, 100);
        return row(Shutter{open, open + log_between(random, 1e-3, 100)}, between(random, 0, 1));
    });
    return probe_check(
        "instant", rows_then(instants, any_exposure),
        {property({.id = "M1",
                   .what = "time from the instant [s]",
                   .violation = of_call<rt::shutter_time>([](double time, const Shutter& s, double) {
                       return s.open < s.close ? 0 : std::abs(time - s.open);
                   }),
                   .tolerance = 1e-5,
                   .says = "a shutter that closes as it opens leaves one time"}),
         property({.id = "M1",
                   .what = "times outside exposures from a millisecond to 100 s",
                   .violation = of_call<rt::shutter_time>([](double time, const Shutter& s, double) {
                       const double margin = 1e-5 * std::max(1.0, std::abs(time));
                       return time >= s.open - margin && time <= s.close + margin ? 0.0 : 1.0;
                   }),
                   .says = "a time is before the shutter opens or after it closes, where the exposure is "
                           "very short or long, or long after the start"}),
         mean_of({.id = "M1",
                  .what = "mean time of exposures from a millisecond to 100 s, as a share of them",
                  .number = of_call<rt::shutter_time>([](double time, const Shutter& s, double u) {
                      return s.open < s.close ? share_of_exposure(time, s, u) : 0.5;
                  }),
                  .truth = 0.5,
                  .unit = 1,
                  .hint = always("times of very short or long exposures are not uniform in them")})});
}

struct Along {
    double mean = 0, variance = 0, kurtosis = 0;
};

/// Moments of a streak along its way, without those of the lamp's own disc and of the pixel.
Along along_way(const rt::Image& image, vec2 center, vec2 along, double radius) {
    double mass = 0, first = 0, second = 0, fourth = 0;
    const auto over_pixels = [&](auto f) {
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                f((x + 0.5 - 20 - center.x) * along.x + (20 - y - 0.5 - center.y) * along.y,
                  brightness(image.at(x, y)));
    };
    over_pixels([&](double s, double light) { mass += light, first += light * s; });
    over_pixels([&](double s, double light) {
        const double square = rt::sqr(s - first / mass);
        second += light * square / mass, fourth += light * square * square / mass;
    });
    // cumulants add up: those of the disc and of the pixel are known
    const double variance = second - radius * radius / 4 - 1.0 / 12;
    const double cumulant =
        fourth - 3 * second * second + std::pow(radius, 4) / 16 + (std::pow(along.x, 4) + std::pow(along.y, 4)) / 120;
    return {first / mass, variance, 3 + cumulant / rt::sqr(variance)};
}

/// A lamp that flies by while the shutter is open: a streak. Along it, the lamp's own disc and the pixel are taken from
/// the moments: what is left is that of the way, uniform over its length.
Check streak(Generator& random) {
    const Place place = any_place(random);
    const double open = between(random, 0.4, 0.8), close = open + between(random, 0.5, 1),
                 turn = between(random, 0, 2 * rt::pi);
    constexpr double pixel = film_pixel, radius = 2;  // [m], [pixel]
    const double length = between(random, 20, 24), middle = (open + close) / 2;
    const vec2 along(std::cos(turn), std::sin(turn)), step = length / (close - open) * along,
                                                      center(between(random, -2, 2), between(random, -2, 2));
    const vec2 start = center - middle * step;  // y up
    const std::string scene = toml(film_view(place, {40, 40})) + shutter(open, close) + unsampled_lamp("lamp", 4) +
                              disc("lamp", place(pixel * vec3(start.x, start.y, 0)), place.axes.z, radius * pixel,
                                   place.turned(pixel * vec3(step.x, step.y, 0)));

    const auto measured = [=](const rt::Image& image) { return along_way(image, center, along, radius); };
    const double due = length * length / 12;
    return render_check("streak", {scene, 64, "sobol"},
                        {of_picture({.id = "M1",
                                     .what = "middle of the streak, from where it must be [pixel]",
                                     .number = [=](const rt::Image& i) { return measured(i).mean; },
                                     .truth = 0,
                                     .delta = 0.8,
                                     .hint = by_value("the middle of the streak, from where it must be [pixel],",
                                                      {{-length * open / (close - open),
                                                        "does time start at 0? It starts when the shutter opens"},
                                                       {-length / 2, "is the lamp seen when the shutter opens alone?"},
                                                       {length / 2, "is the lamp seen when the shutter closes alone?"}},
                                                      1)}),
                         of_picture({.id = "M1",
                                     .what = "variance along the streak, over length^2/12",
                                     .number = [=](const rt::Image& i) { return measured(i).variance / due; },
                                     .delta = 0.08,
                                     .hint = by_ratio("the variance along the streak",
                                                      {{3, "is the lamp seen at the two ends alone?"},
                                                       {0, "there is one time for the whole picture: is u used?"},
                                                       {0.25, "is half of the exposure used?"},
                                                       {4, "is twice the exposure used?"}},
                                                      "times must be uniform between opening and closing")}),
                         of_picture({.id = "M1",
                                     .what = "kurtosis along the streak",
                                     .number = [=](const rt::Image& i) { return measured(i).kurtosis; },
                                     .truth = 1.8,
                                     .delta = 0.15,
                                     .hint = by_value("the kurtosis along the streak, 1.8 for uniform times,",
                                                      {{1, "is the lamp seen at the two ends alone?"}}, 0.1)})});
}

/// A train of three cars, red, green and blue, passes while the shutter is open, so fast that the whole view sees one
/// car at nearly any time: a sample tells its time by its colour. The first and the last car are long: what happens out
/// of the exposure is not asked here.
Check passing_train(Generator& random) {
    const Place place = any_place(random);
    const double open = between(random, 1, 1.4), close = open + between(random, 0.5, 1);
    const double turn = between(random, 0, 2 * rt::pi);
    constexpr int view_size = 16;                        // [pixel]
    constexpr double car = 40 * view_size * film_pixel;  // [m]
    const vec3 along = place.turned({std::cos(turn), std::sin(turn), 0});
    const vec3 side = place.turned({-std::sin(turn), std::cos(turn), 0});
    const vec3 velocity = -3 * car / (close - open) * along;
    std::string scene = toml(film_view(place, {view_size, view_size})) + shutter(open, close);
    const char* colors[] = {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"};
    for (int c = 0; c < 3; ++c) {
        const double from = c == 0 ? -6 : c, to = c == 2 ? 9 : c + 1;  // along the train, at the opening [car]
        const vec3 at_opening = place({0, 0, 0}) + (from + to) / 2 * car * along;
        const std::string name = fmt::format("car{}", c);
        scene += unsampled_lamp(name, colors[c]) +
                 quad(name, at_opening - open * velocity, (to - from) / 2 * car * along, side, velocity);
    }
    constexpr int samples = 4;
    const Region region{0, 0, view_size, view_size};
    const Statistic noise =
        of_picture({.id = "M2",
                    .what = "variance of the times within a picture, over that of independent ones",
                    .number = [=](const rt::Image& image) { return within_variance(image, region, samples); },
                    .delta = 0.35,
                    .hint =
                        [](double value, double) {
                            return fmt::format(
                                "times within one picture vary {:.3g} times as much as independent ones: {}", value,
                                value < 0.1 ? "is there one time for all samples of a picture? Each sample has a time "
                                              "of its own"
                                            : "does each sample have a time of its own, drawn from its u?");
                        }});
    return render_check("passing_train", {scene, samples, "random"},
                        {own_numbers(region, samples, "time", "the same"), noise});
}

}  // namespace

Checks check_shutter_time(Generator& random) {
    return {times(random), even(), instant(), streak(random), passing_train(random)};
}

}  // namespace grade
