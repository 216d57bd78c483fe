#include <fmt/format.h>

#include <array>

#include "checks/kit/draw.h"
#include "checks/kit/pictures.h"
#include "checks/kit/render_check.h"
#include "statistics/regression.h"
#include "statistics/spread.h"

namespace grade {

namespace {

using rt::vec2, rt::vec3;

/// A camera that sees a plane in pixels: film point (x, y) is on_film(place, x, y).
constexpr double pixel = 0.01;  // [m]

View film_view(const Place& place, rt::ivec2 size) {
    return {place({0, 0, 5}), place({0, 0, 0}), place.turned({0, 1, 0}),
            2 * std::atan(size.y * pixel / 2 / 5) * 180 / rt::pi, size};
}

/// A rectangle of light on the film, by its centre and half edges in pixels, y down.
std::string bright(const Place& place, rt::ivec2 size, const std::string& material, vec2 center, vec2 u, vec2 v) {
    const auto turned = [&](vec2 d) { return place.turned(pixel * vec3(d.x, -d.y, 0)); };
    const vec2 c = center - 0.5 * vec2(size);
    const vec3 across = turned(u), along = turned(v);
    // the front side faces the camera
    const bool faces = rt::dot(rt::cross(across, along), place.axes.z) > 0;
    return quad(material, place(pixel * vec3(c.x, -c.y, 0)), across, faces ? along : -along);
}

/// A rectangle whose edge on the left is x = offset + slope y and whose other edges are far from `region` rows.
std::string half_plane(const Place& place, rt::ivec2 size, vec2 on_edge, vec2 along, double width) {
    const vec2 v = along / std::hypot(along.x, along.y), u(v.y, -v.x);  // u to the right of v, which runs down
    return bright(place, size, "lamp", on_edge + 0.5 * width * u, 0.5 * width * u, 40.0 * v);
}

/// Share of a pixel to the right of x = offset + slope y.
double coverage(const Edge& edge, int x, int y) {
    constexpr int rows = 32;
    double sum = 0;
    for (int k = 0; k < rows; ++k)
        sum += std::clamp(x + 1 - edge.offset - edge.slope * (y + (k + 0.5) / rows), 0.0, 1.0);
    return sum / rows;
}

/// N times the mean square of what a pixel on the edge is off by, over what it is for independent samples.
double edge_dispersion(const rt::Image& image, const Edge& edge, int height, double lamp, int samples) {
    double off = 0, independent = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < 32; ++x) {
            const double p = coverage(edge, x, y);
            if (p <= 0 || p >= 1) continue;
            off += rt::sqr(brightness(image.at(x, y)) / lamp - p);
            independent += p * (1 - p);
        }
    return samples * off / independent;
}

}  // namespace

/// Two slanted edges, one for each axis of the film.
Check slanted_edges(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(88, 32);
    const int samples = 16;
    const double lamp = between(random, 1, 4);
    // slope x height is a whole number: each edge falls everywhere in a pixel
    const Edge upright{between(random, 11, 13), std::array{3, 5, 7}[std::size_t(whole_between(random, 0, 2))] / 32.0};
    const Edge level{between(random, 11, 13), std::array{3, 5, 7}[std::size_t(whole_between(random, 0, 2))] / 32.0};
    constexpr int second = 56;  // where the other edge begins
    std::string scene =
        toml(film_view(place, size)) + fmt::format("[materials.lamp]\nemission = {}\nsampled = false\n\n", toml(lamp));
    // bright from the edge to column 32, and dark before column 48, where the next one starts
    const vec2 down = vec2(upright.slope, 1) / std::hypot(upright.slope, 1.0);
    scene += half_plane(place, size, {upright.offset + upright.slope * 16, 16}, {upright.slope, 1}, 28 * down.y);
    const vec2 right = vec2(1, level.slope) / std::hypot(level.slope, 1.0), normal(-right.y, right.x);
    scene += bright(place, size, "lamp", vec2(second + 16, level.offset + level.slope * 16) + 20.0 * normal,
                    20.0 * right, 20.0 * normal);

    const auto spread = [=](const rt::Image& image, bool across) {
        if (across) return slanted_spread(image, {0, 0, 32, 32}, upright, 0, lamp);
        rt::Image part(32, 32);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) part.at(x, y) = image.at(second + x, y);
        return slanted_spread(transposed(part), {0, 0, 32, 32}, level, 0, lamp);
    };
    std::vector<Statistic> statistics;
    for (const bool across : {true, false}) {
        const std::string axis = across ? "across" : "down";
        const Edge edge = across ? upright : level;
        const double due = (1 + rt::sqr(edge.slope)) / 12;
        statistics.push_back(of_picture(
            "A1", "place of an edge " + axis + " the picture, from where it must be [pixel]",
            [=](const rt::Image& image) { return spread(image, across).mean; }, 0, 0.05,
            by_value("an edge's place " + axis + " the picture, from where it must be [pixel],",
                     {{0.5, "are positions shifted by half a pixel?"},
                      {-0.5, "are positions shifted by half a pixel, or is 1/n computed with integers?"},
                      {-0.5 + 0.5 / samples, "is a stratum computed by integer division?"},
                      {0.5 - 0.5 / samples, "is a stratum computed by integer division?"},
                      {1, "are positions shifted by a pixel?"},
                      {-1, "are positions shifted by a pixel?"}},
                     0.06)));
        statistics.push_back(of_picture(
            "A1", "width of an edge " + axis + " the picture: mean square, over that of a pixel",
            [=](const rt::Image& image) { return spread(image, across).mean_square / due; }, 1, 0.15,
            by_value("an edge's mean square width " + axis + " the picture, over that of a pixel,",
                     {{0, "is every sample in the same place? The edge is a staircase"},
                      {4, "do the samples fill two pixels?"},
                      {0.25, "do the samples fill half of the pixel?"}},
                     0.2)));
    }
    Statistic dispersion = of_picture(
        "G2", "noise of the pixels on an edge, over that of independent samples",
        [=](const rt::Image& image) { return edge_dispersion(image, upright, 32, lamp, samples); }, 0.25, 0.35,
        [](double value, double) {
            return value > 0.8 ? fmt::format(
                                     "pixels on an edge have {:.3g} times the noise of independent samples: each "
                                     "sample must fall in a cell of its own",
                                     value)
                               : fmt::format(
                                     "pixels on an edge are {:.3g} times as noisy as independent samples make them; "
                                     "expected about 0.25",
                                     value);
        });
    dispersion.delta0 = 0.15;
    statistics.push_back(dispersion);
    return render_check("slanted_edges", {scene, samples, "stratified"}, statistics);
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
        scene += fmt::format("[materials.stripe{}]\nemission = {}\nsampled = false\n\n", c, colors[c]);
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

/// Lamps of very different brightness, each thinner than the pixels that it crosses: a lamp of 10 that covers 30
/// percent of a pixel reads 3.
Check thin_lamps(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(48, 24);
    constexpr int samples = 32;
    struct Lamp {
        double radiance, cover;
        int row;
    };
    const std::array<Lamp, 3> lamps = {Lamp{between(random, 0.2, 0.6), between(random, 0.4, 0.6), 4},
                                       Lamp{between(random, 5, 12), between(random, 0.25, 0.4), 12},
                                       Lamp{between(random, 100, 300), between(random, 0.4, 0.6), 20}};
    std::string scene = "[render]\nexposure = 0.1\n\n" + toml(film_view(place, size));
    for (std::size_t k = 0; k < lamps.size(); ++k)
        scene +=
            fmt::format("[materials.lamp{}]\nemission = {}\nsampled = false\n\n", k, toml(lamps[k].radiance)) +
            bright(place, size, fmt::format("lamp{}", k), {24, lamps[k].row + 0.5}, {40, 0}, {0, lamps[k].cover / 2});

    std::vector<Statistic> statistics;
    for (const Lamp& lamp : lamps) {
        const double due = lamp.radiance * lamp.cover;
        const std::string what =
            fmt::format("pixels that a lamp of {:.3g} covers to {:.0f} %", lamp.radiance, 100 * lamp.cover);
        statistics.push_back(of_picture(
            "G4", what + ", over what they must be",
            [=](const rt::Image& image) {
                return brightness(region_mean(image, {0, lamp.row, image.width, 1})) / due;
            },
            1, 0.08,
            by_ratio(what, {{1 / lamp.radiance, "is a sample clamped to 1 before the mean?"},
                            {1 / due, "is the mean clamped to 1?"},
                            {std::pow(lamp.radiance, 1 / 2.2 - 1), "does each sample get a gamma of 2.2?"},
                            {std::pow(due, 1 / 2.2 - 1), "does the mean get a gamma of 2.2?"},
                            {double(samples), "is the sum not divided by the number of samples?"},
                            {std::sqrt(double(samples)), "is the sum divided by the root of the number of samples?"},
                            {samples / 25.0, "is the sum divided by floor(sqrt n)^2? There are n samples"},
                            {1 / lamp.cover, "does any sample that meets the lamp count for all?"}})));
    }
    // independent samples: N Var = p (1 - p)
    Statistic noise = of_picture(
        "G2", "noise of these pixels, over that of so many independent samples",
        [=](const rt::Image& image) {
            double off = 0, due = 0;
            for (const Lamp& lamp : lamps)
                for (int x = 0; x < image.width; ++x) {
                    off += rt::sqr(brightness(image.at(x, lamp.row)) / lamp.radiance - lamp.cover) * samples;
                    due += lamp.cover * (1 - lamp.cover);
                }
            return off / due;
        },
        1, 0.6,
        [](double value, double) {
            return value > 10
                       ? fmt::format(
                             "pixels have {:.3g} times the noise of their samples' mean: does one sample alone count?",
                             value)
                       : fmt::format("pixels have {:.3g} times the noise of their samples' mean: do all samples count?",
                                     value);
        });
    statistics.push_back(noise);
    return render_check("thin_lamps", {scene, samples, "random"}, statistics);
}

/// Lamps from a thousandth to a thousand: the picture is linear.
Check lamp_steps(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(56, 16);
    std::vector<rt::Color> radiance;
    std::string scene = toml(film_view(place, size));
    for (int k = 0; k < 7; ++k) {
        radiance.push_back(std::pow(10.0, k - 3) * box(random, 0.7, 1.4));
        scene += fmt::format("[materials.lamp{}]\nemission = {}\nsampled = false\n\n", k, toml(radiance.back())) +
                 bright(place, size, fmt::format("lamp{}", k), {8 * k + 4, 8}, {3.3, 0}, {0, 6.6});
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
    std::vector<Statistic> statistics;
    statistics.push_back(of_picture(
        "G4", "exponent of radiance in the picture", [=](const rt::Image& i) { return line(i, 1).slope.value; }, 1,
        0.01,
        by_value("radiance comes out to the power",
                 {{1 / 2.2, "a gamma of 2.2 is applied: the picture is linear"},
                  {0.5, "a square root is taken: the picture is linear"}},
                 0.05)));
    for (int c = 0; c < 3; ++c) {
        const std::string name = std::array{"red", "green", "blue"}[std::size_t(c)];
        statistics.push_back(of_picture(
            "G4", name + " radiance, a factor off",
            [=](const rt::Image& i) { return std::exp(line(i, c).intercept.value); }, 1, 0.02,
            by_ratio("the " + name + " radiance",
                     {{16, "is the sum not divided by the number of samples?"},
                      {4, "is the sum divided by the root of the number of samples?"}},
                     "is each channel the mean of its own?")));
    }
    return render_check("lamp_steps", {scene, 16, "sobol"}, statistics);
}

}  // namespace grade
