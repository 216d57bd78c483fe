#pragma once

#include <algorithm>

#include "checks/kit/own_density.h"

/// Warps of the unit square: what is common to the checks of directions and densities.
namespace grade {

/// Angle about z as a share of the full turn, 0 to 1.
inline double turn(double x, double y) {
    const double t = std::atan2(y, x) / (2 * rt::pi);
    return t < 0 ? t + 1 : t;
}

/// For a statistic of evenness: says so where one half of the circle about z gets nothing.
inline Cause half_circles(RowPoint point) {
    return [point](const Observation& seen) -> std::string {
        double first = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) first += point(seen.inputs[k], seen.outputs[k]).y < 0.5;
        const double share = first / double(seen.inputs.size());
        return share < 0.02 || share > 0.98
                   ? "only half of the circle is used: the angle runs through a full turn, 2 pi"
                   : "";
    };
}

/// Equal parts of what is sampled about z get equally many samples: `cell` is uniform in the unit square, its second
/// coordinate the turn.
inline Statistic even_about_z(const std::string& id, const std::string& what, const RowPoint& cell, std::string words) {
    return uniform_in_square(
        {.id = id, .what = what, .point = cell, .hint = always(std::move(words)), .cause = half_circles(cell)});
}

/// Each answer is a number, and a direction that counts is a unit vector.
///
/// row_with(random, u)  the fragment's arguments
/// where                "where a coordinate of u is 0, 1/2 or just below 1"
/// more                 arguments as well
template <class RowWith>
Check well_formed(
    const std::string& name, rt::vec2 (*draw_u)(Generator&), RowWith row_with, const std::string& where,
    const std::function<Rows(Generator&)>& more = [](Generator&) { return Rows(); }) {
    const auto middle = [=](Generator& random) { return row_with(random, rt::vec2(0.5)); };
    const auto drawn = [=](Generator& random) {
        const rt::vec2 u = draw_u(random);
        return row_with(random, u);
    };
    const auto inputs = rows_then(rows_then(rows_of(1, middle), rows_of(96, drawn)), more);
    const auto is_finite = [](double x) { return std::isfinite(x); };
    const auto not_finite = [=](const Row&, const Row& out) { return std::ranges::all_of(out, is_finite) ? 0.0 : 1.0; };
    const auto off_one = [](const Row&, const Row& out) {
        const bool counts = std::any_of(out.begin() + std::min<std::ptrdiff_t>(3, std::ssize(out)), out.end(),
                                        [](double x) { return x != 0; });
        return counts ? std::abs(std::hypot(out[0], out[1], out[2]) - 1) : 0.0;
    };
    return probe_check(name, inputs,
                       {property({.id = "V3",
                                  .what = "answers that are no finite numbers, " + where,
                                  .violation = not_finite,
                                  .says = "an answer is no finite number " + where}),
                        property({.id = "V3",
                                  .what = "length of directions " + where + ", off 1 by",
                                  .violation = off_one,
                                  .tolerance = 1e-4,
                                  .says = "the direction is no unit vector " + where})});
}

/// Numbers u at the ends of their range, and in its middle.
template <class RowWith>
Check ends_of_square(RowWith row_with) {
    return well_formed("ends_of_u", seam_of_square, row_with, "where a coordinate of u is 0, 1/2 or just below 1");
}

/// For row_with that draws axes of the world: a frame must exist about each.
///
/// at_ends  arguments as well whose u are at the ends of their range
template <class RowWith>
Check axes_of_the_world(RowWith row_with) {
    return well_formed("axes_of_the_world", square, row_with,
                       "where the direction or the normal is an axis of the world");
}
template <class RowWith>
Check axes_of_the_world(RowWith row_with, const std::function<Rows(Generator&)>& at_ends) {
    return well_formed("axes_of_the_world", square, row_with,
                       "where the normal is an axis of the world, or a coordinate of u is 0, 1/2 or just below 1",
                       at_ends);
}

/// Of a warp whose samples are a direction and its density.
template <auto fragment>
Check density_of_directions(const std::vector<RowWith>& kinds) {
    return density_of_warp(kinds, {of_call<fragment>([](const rt::DirectionSample& s) { return s.direction; }),
                                   of_call<fragment>([](const rt::DirectionSample& s) { return s.density; }),
                                   "the density that is returned"});
}

/// The density that is returned must be that of the direction or point that is returned: density(sample).
template <auto fragment, class Density>
Statistic right_density(Density density, double tolerance, std::vector<KnownValue> known) {
    Statistic s = property({.id = "V3",
                            .what = "returned density, off by its share",
                            .violation = of_call<fragment>([density](const auto& sample) {
                                const double right = density(sample);
                                return std::abs(sample.density - right) / (right + 1e-6);
                            }),
                            .tolerance = tolerance});
    s.cause = [density, known](const Observation& seen) {
        double ratio = 0, count = 0;
        for (const Row& outputs : seen.outputs) {
            const auto sample = result<fragment>(outputs);
            const double right = density(sample);
            if (right > 1e-6) ratio += sample.density / right, ++count;
        }
        return Shown("", by_ratio("the density that is returned", known,
                                  "it is not the density of the returned direction")(ratio / count, 1));
    };
    return s;
}

}  // namespace grade
