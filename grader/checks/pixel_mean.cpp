#include "asked/pixel_mean.h"
#include "checks/kit/kit.h"
#include "statistics/regression.h"

namespace grade {

namespace {

using rt::Color, rt::vec2, rt::vec3;
using Colors = std::vector<Color>;
using Weights = std::vector<double>;

/// The mean of each sample's value: each(radiance, weight).
template <class Each>
auto mean_over_samples(Each each) {
    return [=](const Colors& radiance, const Weights& weight) {
        Color sum(0);
        for (std::size_t i = 0; i < radiance.size(); ++i) sum += each(radiance[i], weight[i]);
        return sum / double(weight.size());
    };
}

/// The right mean as if n stood for of_n(n).
template <class OfN>
auto divided_by(OfN of_n) {
    return [=](Color right, const Colors&, const Weights& w) {
        const double n = double(w.size());
        return right * n / of_n(n);
    };
}

Color rounded(Color c) { return glm::floor(c * 255.0 + 0.5) / 255.0; }

Statistic linear_mean() {
    const auto total = [](const Weights& w) {
        double sum = 0;
        for (const double x : w) sum += x;
        return sum;
    };
    return formula<rt::pixel_mean>(
        {.id = "G4",
         .what = "mean, off by",
         .tolerance = 1e-4,
         .right = mean_over_samples([](Color c, double w) { return w * c; }),
         .suspects = {
             {"the sum is not divided by the number of samples", divided_by([](double) { return 1.0; })},
             {"the sum is divided by the sum of the weights; expected the number of samples",
              [=](Color right, const Colors&, const Weights& w) { return right * double(w.size()) / total(w); }},
             {"black samples are not counted; expected the mean over all",
              [=](Color right, const Colors& c, const Weights& w) {
                  const auto lit = double(c.size()) - double(std::ranges::count(c, Color(0)));
                  return lit > 0 ? right * double(w.size()) / lit : right;
              }},
             {"the weights are ignored", mean_over_samples([](Color c, double) { return c; })},
             {"each sample is clamped to 1 before the mean: radiance has no upper bound",
              mean_over_samples([](Color c, double w) { return w * glm::min(c, Color(1)); })},
             {"the mean is clamped to 1: a preview does that, the image is linear",
              [](Color right) { return glm::min(right, Color(1)); }},
             {"a gamma of 2.2 is applied to each sample: the image is linear",
              mean_over_samples([](Color c, double w) { return w * glm::pow(c, Color(1 / 2.2)); })},
             {"a gamma of 2.2 is applied to the mean: the image is linear",
              [](Color right) { return glm::pow(right, Color(1 / 2.2)); }},
             {"samples are rounded to 8 bits before the mean", mean_over_samples([](Color c, double w) {
                  return w * (glm::floor(glm::min(c, Color(1)) * 255.0) / 255.0);
              })},
             {"samples are rounded to 8 bits before the mean",
              mean_over_samples([](Color c, double w) { return rounded(w * c); })},
             {"the mean is rounded to 8 bits: a preview does that, the image keeps all digits", rounded},
             {"only floor(sqrt n)^2 of the n samples are added",
              [](const Colors& c, const Weights& w) {
                  const auto root = std::size_t(std::sqrt(double(c.size())));
                  Color sum(0);
                  for (std::size_t i = 0; i < root * root; ++i) sum += w[i] * c[i] / double(c.size());
                  return sum;
              }},
             {"the sum is divided by floor(sqrt n)^2; expected n",
              divided_by([](double n) { return rt::sqr(std::floor(std::sqrt(n))); })},
             {"the sum is divided by n - 1; expected n", divided_by([](double n) { return n - 1; })},
             {"the sum is divided by sqrt(n); expected n", divided_by([](double n) { return std::sqrt(n); })},
             {"the channels are exchanged: red for blue", [](Color right) { return Color(right.z, right.y, right.x); }},
             {"the channels are exchanged", [](Color right) { return Color(right.y, right.z, right.x); }},
             {"the channels are exchanged", [](Color right) { return Color(right.z, right.x, right.y); }},
             {"only the first sample counts", [](const Colors& c, const Weights&) { return c[0]; }},
             {"only the last sample counts", [](const Colors& c, const Weights&) { return c.back(); }}}});
}

struct ThinLamp {
    double radiance, cover;  // the share of each pixel of its row that it covers
    int row;
};

/// What the pixels read that a lamp covers in part.
Statistic reading_of(const ThinLamp& lamp, int samples) {
    const double due = lamp.radiance * lamp.cover;
    const std::string what =
        fmt::format("pixels that a lamp of {:.3g} covers to {:.0f} %", lamp.radiance, 100 * lamp.cover);
    return of_picture(
        {.id = "G4",
         .what = what + ", over what they must be",
         .number =
             [=](const rt::Image& image) {
                 return brightness(region_mean(image, {0, lamp.row, image.width, 1})) / due;
             },
         .delta = 0.08,
         .hint =
             by_ratio(what, {{1 / lamp.radiance, "is a sample clamped to 1 before the mean?"},
                             {1 / due, "is the mean clamped to 1?"},
                             {std::pow(lamp.radiance, 1 / 2.2 - 1), "does each sample get a gamma of 2.2?"},
                             {std::pow(due, 1 / 2.2 - 1), "does the mean get a gamma of 2.2?"},
                             {double(samples), "is the sum not divided by the number of samples?"},
                             {std::sqrt(double(samples)), "is the sum divided by the root of the number of samples?"},
                             {samples / 25.0, "is the sum divided by floor(sqrt n)^2? There are n samples"},
                             {1 / lamp.cover, "does any sample that meets the lamp count for all?"}})});
}

/// Lamps of very different brightness, each thinner than the pixels that it crosses: a lamp of 10 that covers 30
/// percent of a pixel reads 3.
Check thin_lamps(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(48, 24);
    constexpr int samples = 32;
    const std::array<ThinLamp, 3> lamps = {ThinLamp{between(random, 0.2, 0.6), between(random, 0.4, 0.6), 4},
                                           ThinLamp{between(random, 5, 12), between(random, 0.25, 0.4), 12},
                                           ThinLamp{between(random, 100, 300), between(random, 0.4, 0.6), 20}};
    std::string scene = scene_table("[render]", {{"exposure", 0.1}}) + toml(film_view(place, size));
    for (std::size_t k = 0; k < lamps.size(); ++k) {
        const std::string name = fmt::format("lamp{}", k);
        scene += unsampled_lamp(name, lamps[k].radiance) +
                 bright(place, size, name, {24, lamps[k].row + 0.5}, {40, 0}, {0, lamps[k].cover / 2});
    }

    std::vector<Statistic> statistics;
    for (const ThinLamp& lamp : lamps) statistics.push_back(reading_of(lamp, samples));
    // independent samples: N Var = p (1 - p)
    const auto noise = [=](const rt::Image& image) {
        double off = 0, due = 0;
        for (const ThinLamp& lamp : lamps)
            for (int x = 0; x < image.width; ++x) {
                off += rt::sqr(brightness(image.at(x, lamp.row)) / lamp.radiance - lamp.cover) * samples;
                due += lamp.cover * (1 - lamp.cover);
            }
        return off / due;
    };
    statistics.push_back(of_picture({.id = "G2",
                                     .what = "variance of these pixels, over that of so many independent samples",
                                     .number = noise,
                                     .delta = 0.6,
                                     .hint = [](double value, double) {
                                         return fmt::format(
                                             "pixels have {:.3g} times the variance of their samples' mean: {}", value,
                                             value > 10 ? "does one sample alone count?" : "do all samples count?");
                                     }}));
    return render_check("thin_lamps", {scene, samples, "random"}, statistics);
}

/// Lamps from a thousandth to a thousand: the picture is linear.
Check lamp_steps(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(56, 16);
    std::vector<Color> radiance;
    std::string scene = toml(film_view(place, size));
    for (int k = 0; k < 7; ++k) {
        radiance.push_back(std::pow(10.0, k - 3) * box(random, 0.7, 1.4));
        const std::string name = fmt::format("lamp{}", k);
        scene += unsampled_lamp(name, radiance.back()) + bright(place, size, name, {8 * k + 4, 8}, {3.3, 0}, {0, 6.6});
    }
    // the rims of the lamps are noisy, their middles are not
    const auto line = [=](const rt::Image& image, int channel) {
        std::vector<double> in, out;
        for (int k = 0; k < 7; ++k) {
            in.push_back(std::log(radiance[std::size_t(k)][channel]));
            out.push_back(std::log(region_mean(image, {8 * k + 2, 4, 4, 8})[channel]));
        }
        return fit_line(in, out);
    };
    std::vector<Statistic> statistics = rgb([&](int c, const std::string& name) {
        return of_picture({.id = "G4",
                           .what = name + " radiance, a factor off",
                           .number = [=](const rt::Image& i) { return std::exp(line(i, c).intercept); },
                           .delta = 0.02,
                           .hint = by_ratio("the " + name + " radiance",
                                            {{16, "is the sum not divided by the number of samples?"},
                                             {4, "is the sum divided by the root of the number of samples?"}},
                                            "is each channel the mean of its own?")});
    });
    statistics.insert(statistics.begin(),
                      of_picture({.id = "G4",
                                  .what = "exponent of radiance in the picture",
                                  .number = [=](const rt::Image& i) { return line(i, 1).slope; },
                                  .delta = 0.01,
                                  .hint = by_value("radiance comes out to the power",
                                                   {{1 / 2.2, "a gamma of 2.2 is applied: the picture is linear"},
                                                    {0.5, "a square root is taken: the picture is linear"}},
                                                   0.05)}));
    return render_check("lamp_steps", {scene, 16, "sobol"}, statistics);
}

/// So many pixels of a floor that what goes wrong once in 100,000 is seen.
Check many_pixels(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(1200, 1000);
    const vec3 light = place({box(random, -0.3, 0.3).x, box(random, -0.3, 0.3).y, between(random, 1, 2)});
    const double intensity = log_between(random, 40, 120), albedo = between(random, 0.4, 0.8);
    const View view = film_view(place, size);
    const std::string scene = toml(view) + material("floor", {{"albedo", albedo}}) + point_light(light, intensity) +
                              place.floor("floor", 100);
    const rt::Camera camera = camera_of(view);
    const auto due = [=](int x, int y) {
        const vec3 to_light = light - seen_on_plane(camera, {x + 0.5, y + 0.5}, place.origin, place.axes.z);
        const double r = glm::length(to_light);
        return albedo / rt::pi * intensity * rt::dot(to_light, place.axes.z) / (r * r * r);
    };
    // the floor is even: a pixel is as those beside it, and some are compared with what they must be
    const auto odd = [=](const rt::Image& image) {
        constexpr int step = 100;
        double count = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 1; x + 1 < image.width; ++x) {
                const Color beside = (image.at(x - 1, y) + image.at(x + 1, y)) / 2.0;
                const Color off = image.at(x, y) / (x % step == y % step ? Color(due(x, y)) : beside) - 1.0;
                count += !(std::max({std::abs(off.x), std::abs(off.y), std::abs(off.z)}) < 0.02);
            }
        return count;
    };
    return render_check(
        "many_pixels", {scene, 1, "random"},
        {of_picture({.id = "G4",
                     .what = "pixels, of 1,200,000, that are off by two percent",
                     .number = odd,
                     .truth = 0,
                     .exact = true,
                     .hint = with_value("{:.0f} pixels of 1,200,000 are not what they must be: is something else than "
                                        "the mean returned, for some sums?")})});
}

}  // namespace

Checks check_pixel_mean(Generator& random) {
    const auto inputs = rows_of(64, [](Generator& random) {
        const int n = chance(random, 0.1)    ? 1
                      : chance(random, 0.06) ? int(log_between(random, 100, 3000))
                                             : whole_between(random, 2, 30);
        Colors radiance;
        Weights weight;
        for (int i = 0; i < n; ++i) {
            // a bright emitter among dim surfaces, or nothing: radiance has no upper bound, and what is black counts
            radiance.push_back(chance(random, 0.1)    ? Color(0)
                               : chance(random, 0.05) ? box(random, 1e3, 1e6)
                               : chance(random, 0.2)  ? box(random, 5, 50)
                               : chance(random, 0.2)
                                   ? with_channels(box(random, 0, 0.9), whole_between(random, 1, 6), 0)
                                   : box(random, 0, 0.9));
            weight.push_back(between(random, 0.2, 1.6));
        }
        return row(radiance, weight);
    });
    return {probe_check("linear_mean", inputs, {linear_mean()}), lamp_steps(random), thin_lamps(random),
            many_pixels(random)};
}

}  // namespace grade
