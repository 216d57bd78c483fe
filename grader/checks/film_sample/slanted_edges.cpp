#include "checks/film_sample/checks.h"

#include <fmt/format.h>

#include <array>

#include "checks/kit/render_check.h"
#include "statistics/spread.h"

namespace grade::film_sample {

namespace {

using rt::vec2;

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

/// Place and width of an edge along an axis of the picture.
std::vector<Statistic> of_edge(const std::string& axis, const Edge& edge, int samples,
                               std::function<SlantedSpread(const rt::Image&)> spread) {
    const double due = (1 + rt::sqr(edge.slope)) / 12;
    return {of_picture(
                {.id = "A1",
                 .what = "place of an edge " + axis + " the picture, from where it must be [pixel]",
                 .number = [=](const rt::Image& image) { return spread(image).mean; },
                 .truth = 0,
                 .delta = 0.05,
                 .hint = by_value("an edge's place " + axis + " the picture, from where it must be [pixel],",
                                  {{0.5, "are positions shifted by half a pixel?"},
                                   {-0.5, "are positions shifted by half a pixel, or is 1/n computed with integers?"},
                                   {-0.5 + 0.5 / samples, "is a stratum computed by integer division?"},
                                   {0.5 - 0.5 / samples, "is a stratum computed by integer division?"},
                                   {1, "are positions shifted by a pixel?"},
                                   {-1, "are positions shifted by a pixel?"}},
                                  0.06)}),
            of_picture({.id = "A1",
                        .what = "width of an edge " + axis + " the picture: mean square, over that of a pixel",
                        .number = [=](const rt::Image& image) { return spread(image).mean_square / due; },
                        .delta = 0.15,
                        .hint = by_value("an edge's mean square width " + axis + " the picture, over that of a pixel,",
                                         {{0, "is every sample in the same place? The edge is a staircase"},
                                          {4, "do the samples fill two pixels?"},
                                          {0.25, "do the samples fill half of the pixel?"}},
                                         0.2)})};
}

}  // namespace

Check slanted_edges(Generator& random) {
    const Place place = any_place(random);
    const rt::ivec2 size(88, 32);
    const int samples = 16;
    const double lamp = between(random, 1, 4);
    // slope x height is a whole number: each edge falls everywhere in a pixel
    const Edge upright{between(random, 11, 13), std::array{3, 5, 7}[std::size_t(whole_between(random, 0, 2))] / 32.0};
    const Edge level{between(random, 11, 13), std::array{3, 5, 7}[std::size_t(whole_between(random, 0, 2))] / 32.0};
    constexpr int second = 56;  // where the other edge begins
    std::string scene = toml(film_view(place, size)) + unsampled_lamp("lamp", lamp);
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
    for (const bool across : {true, false})
        statistics = joined(statistics, of_edge(across ? "across" : "down", across ? upright : level, samples,
                                                [=](const rt::Image& image) { return spread(image, across); }));
    statistics.push_back(of_picture(
        {.id = "G2",
         .what = "variance of the pixels on an edge, over that of independent samples",
         .number = [=](const rt::Image& image) { return edge_dispersion(image, upright, 32, lamp, samples); },
         .truth = 0.25,
         .delta = 0.35,
         .delta0 = 0.15,
         .hint =
             [](double value, double) {
                 const char* words = value > 0.8
                                         ? "pixels on an edge have {:.3g} times the variance of independent "
                                           "samples: each sample must fall in a cell of its own"
                                         : "pixels on an edge have {:.3g} times the variance that independent samples "
                                           "leave; expected about 0.25";
                 return fmt::format(fmt::runtime(words), value);
             }}));
    return render_check("slanted_edges", {scene, samples, "stratified"}, statistics);
}

}  // namespace grade::film_sample
