#include "checks/kit/own_density.h"

#include <algorithm>
#include <cmath>

namespace grade {

namespace {

constexpr double step = 1e-3;  // of u: the noise of single precision, over it, is below the tolerance
constexpr double tolerance = 5e-3;
constexpr int columns = 8, rows_of_cells = 6;
constexpr std::size_t points = columns * rows_of_cells;  // of each kind of arguments, one in each cell of the square
constexpr std::size_t to_each_edge = 5;                  // points in decades from 1e-3 to 0.1 of it
constexpr std::size_t strata = 128;                      // along an axis, each with two numbers side by side
constexpr std::size_t each = 5;                          // rows: u, and u before and behind along each axis
constexpr std::size_t least = 10;                        // samples that count

/// p |dx/du| at each sample that counts, in order.
std::vector<double> products(const Observation& seen, const OwnDensity& of, std::size_t count) {
    std::vector<double> all;
    for (std::size_t k = 0; k + each <= std::min(count * each, seen.outputs.size()); k += each) {
        const auto at = [&](std::size_t i) { return of.place(seen.inputs[k + i], seen.outputs[k + i]); };
        const auto counts = [&](std::size_t i) { return of.density(seen.inputs[k + i], seen.outputs[k + i]) > 0; };
        if (!counts(0) || !counts(1) || !counts(2) || !counts(3) || !counts(4)) continue;
        const rt::vec3 along = (at(2) - at(1)) / (2 * step), across = (at(4) - at(3)) / (2 * step);
        const double spread = glm::length(of.dimensions == 1 ? along : rt::cross(along, across));
        if (const double p = of.density(seen.inputs[k], seen.outputs[k]) * spread; std::isfinite(p)) all.push_back(p);
    }
    std::ranges::sort(all);
    return all;
}

/// What is furthest from what it may be: 1 where all are right. A few are let pass: a map may have a seam.
double off_most(const std::vector<double>& sorted) {
    if (sorted.size() < least) return 1;
    const std::size_t few = sorted.size() / 20;
    const double low = sorted[few], high = sorted[sorted.size() - 1 - few], middle = sorted[sorted.size() / 2];
    if (low < 1 - tolerance) return low;
    // a mixture is above 1 by other shares in other places; a constant is none
    const bool is_constant = high - low < tolerance * middle;
    return is_constant && std::abs(middle - std::round(middle)) > tolerance * middle ? middle : 1;
}

/// A point of a cell with those beside it. Left out is the square's rim, where maps are steep, and the middle of a
/// disk, where neighbours are so close that single precision does not tell them apart.
Rows about(const RowWith& row_with, Generator& random, std::size_t cell) {
    const rt::vec2 of_cell(double(cell % columns), double(cell / columns));
    const rt::vec2 u = rt::vec2(0.1) + 0.87 * (of_cell + square(random)) / rt::vec2(columns, rows_of_cells);
    const Generator same = random;
    Rows rows;
    for (const rt::vec2 off : {rt::vec2(0), {-step, 0}, {step, 0}, {0, -step}, {0, step}}) {
        random = same;
        rows.push_back(row_with(random, u + off));
    }
    return rows;
}

/// How far from an edge of the square a point near it is at least; those beside it are a tenth of that away.
double from_edge(std::size_t point) { return std::pow(10, -3 + 2.0 * double(point % to_each_edge) / to_each_edge); }

std::size_t points_near_edges(int dimensions) { return 2 * std::size_t(dimensions) * to_each_edge; }

/// A point near an edge with those beside it.
Rows near_edge(const RowWith& row_with, Generator& random, std::size_t point) {
    const std::size_t edge = point / to_each_edge, axis = edge / 2;
    const double away = from_edge(point) * std::pow(10, between(random, 0, 2.0 / to_each_edge));
    const double beside = 0.1 * from_edge(point);
    rt::vec2 u = rt::vec2(0.05) + 0.9 * square(random);
    u[int(axis)] = edge % 2 == 0 ? away : 1 - away;
    const Generator same = random;
    Rows rows;
    for (const rt::vec2 off : {rt::vec2(0), {-beside, 0}, {beside, 0}, {0, -beside}, {0, beside}}) {
        random = same;
        rows.push_back(row_with(random, u + off));
    }
    return rows;
}

/// Numbers side by side along each axis, in all parts of the square.
Rows side_by_side(const RowWith& row_with, Generator& random, int dimensions) {
    Rows rows;
    for (int axis = 0; axis < dimensions; ++axis)
        for (std::size_t k = 0; k < strata; ++k) {
            rt::vec2 u = square(random);
            u[axis] = (double(k) + between(random, 0, 1)) / double(strata);
            u = rt::vec2(step) + (1 - 3 * step) * u;
            const Generator same = random;
            rows.push_back(row_with(random, u));
            random = same, u[axis] += step;
            rows.push_back(row_with(random, u));
        }
    return rows;
}

/// How often two of these have one answer.
Statistic all_differ(const std::vector<OwnDensity>& all, std::size_t count) {
    const auto stuck = [all, count](const Observation& seen) {
        double number = 0;
        for (std::size_t k = count * each; k + 1 < seen.outputs.size(); k += 2) {
            const auto counts = [&](std::size_t i) {
                return std::ranges::any_of(
                    all, [&](const OwnDensity& of) { return of.density(seen.inputs[i], seen.outputs[i]) > 0; });
            };
            const auto at = [&](std::size_t i) { return all.front().place(seen.inputs[i], seen.outputs[i]); };
            number += counts(k) && counts(k + 1) && at(k) == at(k + 1);
        }
        return number;
    };
    return {.id = "V3",
            .what = "different numbers u with one answer",
            .measure = stuck,
            .truth = 0,
            .exact = true,
            .hint = always("different numbers u have one answer: is u clamped or rounded, or a number not used?")};
}

/// p |dx/du| at a point, by those of its neighbours that are the furthest: where a map folds, those on both sides may
/// be one.
double widest_product(const Observation& seen, const OwnDensity& of, std::size_t first, double beside) {
    const auto at = [&](std::size_t i) { return of.place(seen.inputs[first + i], seen.outputs[first + i]); };
    const rt::vec3 along[] = {at(2) - at(0), at(0) - at(1)}, across[] = {at(4) - at(0), at(0) - at(3)};
    double most = 0;
    for (const rt::vec3 x : along)
        for (const rt::vec3 y : across)
            most = std::max(
                most, of.dimensions == 1 ? glm::length(x) / beside : glm::length(rt::cross(x, y)) / rt::sqr(beside));
    return most * of.density(seen.inputs[first], seen.outputs[first]);
}

/// Of the points in the cells and near the edges: at how many the answers are far closer together than they may be.
///
/// kinds  of arguments, which take turns
Statistic none_drawn_together(const std::vector<OwnDensity>& all, std::size_t kinds) {
    const auto number = [all, kinds](const Observation& seen) {
        constexpr double far_below = 0.5;  // 1
        const std::size_t inside = points * kinds, count = inside + points_near_edges(all.front().dimensions) * kinds;
        double together = 0;
        for (std::size_t k = 0; k < count && (k + 1) * each <= seen.outputs.size(); ++k)
            for (const OwnDensity& of : all) {
                bool counts = true;
                for (std::size_t i = k * each; i < (k + 1) * each; ++i)
                    counts = counts && of.density(seen.inputs[i], seen.outputs[i]) > 0;
                const double beside = k < inside ? step : 0.1 * from_edge((k - inside) / kinds);
                together += counts && widest_product(seen, of, k * each, beside) < far_below;
            }
        return together;
    };
    return {.id = "V3",
            .what = "numbers u about which the answers are far closer together than their density says",
            .measure = number,
            .truth = 0,
            .exact = true,
            .cause = [](const Observation&) {
                return Shown(
                    "some numbers u give answers that are nearly one: a cosine, a radius or u is kept above "
                    "or below something");
            }};
}

Statistic over_spread(const OwnDensity& of, std::size_t count) {
    const auto hint = [words = of.words](double value, double) {
        return fmt::format("{} is {:.3g} times that by which neighbouring numbers u are spread", words, value);
    };
    return {.id = "V3",
            .what = of.words + ", over that by which neighbouring numbers u are spread",
            .measure = [of, count](const Observation& seen) { return off_most(products(seen, of, count)); },
            .truth = 1,
            .delta = tolerance,
            .exact = true,
            .hint = hint};
}

}  // namespace

Check own_density(const std::vector<RowWith>& kinds, const std::vector<OwnDensity>& all) {
    const int dimensions = all.front().dimensions;
    const std::size_t inside = points * kinds.size(), at_edges = points_near_edges(dimensions) * kinds.size();
    const auto inputs = [=](Generator& random) {
        Rows rows;
        for (std::size_t k = 0; k < inside; ++k)
            for (Row& one : about(kinds[k % kinds.size()], random, k / kinds.size())) rows.push_back(std::move(one));
        for (std::size_t k = 0; k < at_edges; ++k)
            for (Row& one : near_edge(kinds[k % kinds.size()], random, k / kinds.size()))
                rows.push_back(std::move(one));
        for (const RowWith& kind : kinds) rows = joined(std::move(rows), side_by_side(kind, random, dimensions));
        return rows;
    };
    std::vector<Statistic> statistics;
    for (const OwnDensity& of : all) statistics.push_back(over_spread(of, inside));
    statistics.push_back(all_differ(all, inside + at_edges));
    statistics.push_back(none_drawn_together(all, kinds.size()));
    return probe_check("own_density", inputs, statistics);
}

Check density_of_warp(const std::vector<RowWith>& kinds, const OwnDensity& of) {
    const auto stretched = [place = of.place](const Observation& seen) {
        std::vector<double> all;
        for (std::size_t k = 0; k < points; ++k)
            all.push_back(glm::length(place(seen.inputs[each * k + 4], seen.outputs[each * k + 4]) -
                                      place(seen.inputs[each * k + 3], seen.outputs[each * k + 3])) /
                          (2 * step));
        const auto middle = all.begin() + std::ptrdiff_t(all.size() / 2);
        std::ranges::nth_element(all, middle);
        return *middle;
    };
    Check check = own_density(kinds, {of});
    check.statistics.insert(  // it says more
        check.statistics.begin(),
        {.id = "V3",
         .what = "how far apart neighbours of the unit square come",
         .measure = stretched,
         .truth = 0,
         .delta = 40,
         .exact = true,
         .hint = always("numbers u side by side give answers far apart: is an angle in degrees where cos and sin take "
                        "radians? One turn is 2 pi")});
    return check;
}

}  // namespace grade
