#include "asked/cosine_hemisphere.h"
#include "asked/stratified_2d.h"
#include "asked/uniform_disk.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::DirectionSample, rt::DiskSample, rt::Extent, rt::FilmSample, rt::vec2, rt::vec3;

/// Cells of x strata: inside the square, of the right area, each its own.
double strata_count(double x, Generator& random, const Asker& ask) {
    const int n = int(x);
    Rows rows;
    std::vector<int> cells{0, n / 2, std::max(0, n - 2)};
    for (int i = 0; i < 60; ++i) cells.push_back(whole_between(random, 0, std::max(0, n - 2)));
    const int next = n > 1 ? 1 : 0;
    for (const int i : cells) {
        rows.push_back(row(i, n, vec2(0)));
        rows.push_back(row(i, n, vec2(almost_one)));
        rows.push_back(row(i + next, n, vec2(0.5)));
    }
    const Rows out = ask.probe("stratified_2d", rows);
    double worst = 0;
    for (const Row& point : out)
        for (const double c : point)
            if (!(c >= 0 && c <= 1)) return rt::inf;
    for (std::size_t k = 0; k + 2 < out.size(); k += 3) {
        const vec2 a = from_row<vec2>(out[k]), b = from_row<vec2>(out[k + 1]), other = from_row<vec2>(out[k + 2]);
        const vec2 low = glm::min(a, b), high = glm::max(a, b);
        worst = worse_error(worst, std::abs((high.x - low.x) * (high.y - low.y) * n - 1));
        // the middle of the next cell is not in this one
        const bool within = other.x > low.x && other.x < high.x && other.y > low.y && other.y < high.y;
        if (next && within) return rt::inf;
    }
    return worst;
}

/// The last cells of few strata, with a random number that is so near 1: still below 1.
double strata_end(double x, Generator&, const Asker& ask) {
    Rows rows;
    for (int n = 1; n <= 100; ++n) {
        const double u = std::min(1 - x, almost_one);
        rows.push_back(row(n - 1, n, vec2(u))), rows.push_back(row(n / 2, n, vec2(u))),
            rows.push_back(row(0, n, vec2(u)));
    }
    return worst_of<rt::stratified_2d>(ask, "stratified_2d", rows,
                                       [](vec2 p) { return p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1 ? 0 : rt::inf; });
}

/// A pixel so far from the film's corner: all samples are in it, and fill a cell of the right area each.
double film_position(double x, Generator& random, const Asker& ask) {
    double worst = 0;
    for (int pixel = 0; pixel < 20; ++pixel) {
        const vec2 low(std::floor(x * between(random, 1, 2)), std::floor(x * between(random, 1, 2)));
        Rows rows;
        for (int i = 0; i < 16; ++i)
            for (const double u : {0.0, 0.25, 0.8125, almost_one})
                rows.push_back(row(Extent{low, low + 1.0}, i, 16, vec2(u)));
        const Rows out = ask.probe("film_sample", rows);
        for (std::size_t k = 0; k < out.size(); ++k) {
            const auto [p, weight] = from_row<FilmSample>(out[k]);
            if (!(p.x >= low.x && p.y >= low.y && p.x <= low.x + 1 && p.y <= low.y + 1)) return rt::inf;
            if (k % 4 != 2) continue;
            const vec2 way = (p - from_row<FilmSample>(out[k - 1]).position) / (0.8125 - 0.25);
            worst = worse_error(worst, std::abs(16 * std::abs(way.x * way.y) - 1) / rt::largest(vec3(low, 1)));
        }
    }
    return worst;
}

/// Points of the unit square at a distance x from its borders and from its middle, and, in the extreme, on them.
std::vector<vec2> borders(double x) {
    std::vector<double> places{x, 1 - x, 0.5 + x, 0.5 - x};
    if (x < 1e-3) places.insert(places.end(), {0.0, 0.5, almost_one});
    std::vector<vec2> points;
    for (const double a : places)
        for (const double b : places) points.emplace_back(std::min(a, almost_one), std::min(b, almost_one));
    for (int turn = 0; turn < 64; ++turn) points.emplace_back(std::min(1 - x, almost_one), (turn + 0.37) / 64);
    return points;
}

double disk_border(double x, Generator&, const Asker& ask) {
    const Rows rows = rows_at(borders(x), [](vec2 u) { return row(u); });
    return worst_of<rt::uniform_disk>(ask, "uniform_disk", rows, [](const DiskSample& sample) {
        const auto [p, density] = sample;
        return worse_error(std::max(0.0, glm::length(p) - 1) + 0 * p.x, std::abs(density * rt::pi - 1));
    });
}

double hemisphere_border(double x, Generator&, const Asker& ask) {
    const Rows rows = rows_at(borders(x), [](vec2 u) { return row(u); });
    return worst_of<rt::cosine_hemisphere>(ask, "cosine_hemisphere", rows, [](const DirectionSample& sample) {
        const auto [d, density] = sample;
        if (!(d.z >= 0)) return rt::inf;
        return worse_error(std::abs(glm::length(d) - 1), std::abs(density - d.z / rt::pi));
    });
}

}  // namespace

std::vector<Family> warp_families() {
    constexpr double u = rt::roundoff;
    return {
        Family("strata_count", {"stratified_2d"}, "number of cells", "relative error of a cell's area",
               {.tolerance = 1e-4, .bound = 1e-9, .decades = sweep(0, 9), .scored = {0, 4}}, strata_count),
        Family("strata_end", {"stratified_2d"}, "distance of u from 1", "points at 1",
               {.tolerance = 0, .decades = sweep(-16, -1), .scored = {-3, -1}}, strata_end),
        Family("film_position", {"film_sample"}, "place of a pixel on the film", "error of a cell's area / place",
               {.tolerance = 1e-3, .bound = 64 * u, .decades = sweep(0, 9), .scored = {0, 3}}, film_position),
        Family("disk_border", {"uniform_disk"}, "distance of u from a border", "length beyond 1, error of the density",
               {.bound = 8 * u, .decades = sweep(-16, -1), .scored = {-3, -1}}, disk_border),
        Family("hemisphere_border", {"cosine_hemisphere"}, "distance of u from a border", "error of length and density",
               {.bound = 8 * u, .decades = sweep(-16, -1), .scored = {-3, -1}}, hemisphere_border)};
}

}  // namespace grade::stress
