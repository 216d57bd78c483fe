#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/pictures.h"
#include "checks/kit/render_check.h"
#include "statistics/region.h"
#include "statistics/sharing.h"

namespace grade {

using rt::vec2, rt::vec3;

/// A lamp that flies by while the shutter is open: a streak. Along it, the lamp's own disc and the pixel are taken from
/// the moments: what is left is that of the way, uniform over its length.
Check streak(Generator& random) {
    const Place place = any_place(random);
    const double open = between(random, 0.4, 0.8), close = open + between(random, 0.5, 1),
                 turn = between(random, 0, 2 * rt::pi);
    constexpr double pixel = 0.01, radius = 2;  // [m] of a pixel, across the plane of the lamp; [pixel]
    const double length = between(random, 20, 24), middle = (open + close) / 2;
    const vec2 along(std::cos(turn), std::sin(turn)), step = length / (close - open) * along,
                                                      center(between(random, -2, 2), between(random, -2, 2));
    const vec2 start = center - middle * step;  // y up
    const View view{place({0, 0, 5}),
                    place({0, 0, 0}),
                    place.turned({0, 1, 0}),
                    2 * std::atan(20 * pixel / 5) * 180 / rt::pi,
                    {40, 40}};
    const std::string scene =
        fmt::format("{}[shutter]\nopen = {}\nclose = {}\n\n[materials.lamp]\nemission = 4\nsampled = false\n\n",
                    toml(view), toml(open), toml(close)) +
        disc("lamp", place(pixel * vec3(start.x, start.y, 0)), place.axes.z, radius * pixel,
             place.turned(pixel * vec3(step.x, step.y, 0)));

    struct Along {
        double mean = 0, variance = 0, kurtosis = 0;
    };
    const auto measured = [=](const rt::Image& image) {
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
        const double cumulant = fourth - 3 * second * second + std::pow(radius, 4) / 16 +
                                (std::pow(along.x, 4) + std::pow(along.y, 4)) / 120;
        return Along{first / mass, variance, 3 + cumulant / rt::sqr(variance)};
    };
    const double due = length * length / 12;
    return render_check(
        "streak", {scene, 64, "sobol"},
        {of_picture(
             "M1", "middle of the streak, from where it must be [pixel]",
             [=](const rt::Image& i) { return measured(i).mean; }, 0, 0.8,
             by_value("the middle of the streak, from where it must be [pixel],",
                      {{-length * open / (close - open), "does time start at 0? It starts when the shutter opens"},
                       {-length / 2, "is the lamp seen when the shutter opens alone?"},
                       {length / 2, "is the lamp seen when the shutter closes alone?"}},
                      1)),
         of_picture(
             "M1", "variance along the streak, over length^2/12",
             [=](const rt::Image& i) { return measured(i).variance / due; }, 1, 0.08,
             by_ratio("the variance along the streak",
                      {{3, "is the lamp seen at the two ends alone?"},
                       {0, "there is one time for the whole picture: is u used?"},
                       {0.25, "is half of the exposure used?"},
                       {4, "is twice the exposure used?"}},
                      "times must be uniform between opening and closing")),
         of_picture(
             "M1", "kurtosis along the streak", [=](const rt::Image& i) { return measured(i).kurtosis; }, 1.8, 0.15,
             by_value("the kurtosis along the streak, 1.8 for uniform times,",
                      {{1, "is the lamp seen at the two ends alone?"}}, 0.1))});
}

/// A train of three cars, red, green and blue, passes while the shutter is open, so fast that the whole view sees one
/// car at nearly any time: a sample tells its time by its colour. The first and the last car go on beyond the exposure.
Check passing_train(Generator& random) {
    const Place place = any_place(random);
    const double open = between(random, 0.4, 0.8), close = open + between(random, 0.5, 1);
    const double turn = between(random, 0, 2 * rt::pi);
    constexpr double pixel = 0.01, view_size = 16, car = 40 * view_size * pixel;  // [m], [pixel], [m]
    const vec3 along = place.turned({std::cos(turn), std::sin(turn), 0});
    const vec3 side = place.turned({-std::sin(turn), std::cos(turn), 0});
    const vec3 velocity = -3 * car / (close - open) * along;
    const View view{place({0, 0, 5}),
                    place({0, 0, 0}),
                    place.axes.y,
                    2 * std::atan(view_size / 2 * pixel / 5) * 180 / rt::pi,
                    {int(view_size), int(view_size)}};
    std::string scene = toml(view) + fmt::format("[shutter]\nopen = {}\nclose = {}\n\n", toml(open), toml(close));
    const char* colors[] = {"[1, 0, 0]", "[0, 1, 0]", "[0, 0, 1]"};
    for (int c = 0; c < 3; ++c) {
        const double from = c == 0 ? -0.5 : c, to = c == 2 ? 3.5 : c + 1;  // along the train, at the opening [car]
        const vec3 at_opening = place({0, 0, 0}) + (from + to) / 2 * car * along;
        scene +=
            fmt::format("[materials.car{}]\nemission = {}\nsampled = false\n\n", c, colors[c]) +
            quad(fmt::format("car{}", c), at_opening - open * velocity, (to - from) / 2 * car * along, side, velocity);
    }
    constexpr int samples = 4;
    const Region region{0, 0, int(view_size), int(view_size)};
    Statistic noise = of_picture("M2", "variance of the times within a picture, over that of independent ones",
        [=](const rt::Image& image) { return within_variance(image, region, samples); }, 1, 0.35,
        [](double value, double) {
            const bool none = value < 0.1;
            return fmt::format("times within one picture vary {:.3g} times as much as independent ones: {}", value,
                               none
                                   ? "is there one time for all samples of a picture? Each sample has a time of its own"
                                   : "does each sample have a time of its own, drawn from its u?");
        });
    return render_check("passing_train", {scene, samples, "random"},
                        {own_numbers(region, samples, "time", "the same"), noise});
}

Statistic own_numbers(const Region& region, int samples, const std::string& what, const std::string& otherwise) {
    Statistic s = of_picture("G1", "share of the noise that pixels have in common: of the picture, a row, a column",
        [=](const rt::Image& image) { return sharing(image, region, samples).sum(); }, 0, 0.4,
        [=](double value, double) {
            return fmt::format("pixels share {:.3g} of their noise: is one {} drawn for many pixels?", value, what);
        });
    s.cause = [=](const Observation& seen) {
        const Sharing shared = sharing(seen.image, region, samples);
        if (shared.all > 0.7)
            return fmt::format(
                "all pixels have one {}: it is drawn once, or is always {}; it must come from u, which is "
                "another for each sample of each pixel",
                what, otherwise);
        if (shared.rows > 0.5) return fmt::format("all pixels of a row have one {}: it must come from u alone", what);
        if (shared.columns > 0.5)
            return fmt::format("all pixels of a column have one {}: it must come from u alone", what);
        return std::string();
    };
    return s;
}

}  // namespace grade
