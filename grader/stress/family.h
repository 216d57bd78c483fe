#pragma once

#include <functional>
#include <string>
#include <vector>

#include "checks/kit/call.h"
#include "checks/kit/probe_check.h"

/// Families of extreme cases, as data. A family is one quantity that is swept over decades, and one error that is
/// measured in what fragments answer.
namespace grade::stress {

/// What a family asks of a submission. Both throw Broken where no answer comes back.
struct Asker {
    std::function<Rows(const std::string& fragment, const Rows& rows)> probe;
    std::function<rt::Image(const std::string& scene, int samples)> render;  // with the sampler "random", seed 1
};

/// Decades of a sweep, both ends included. low > high: none.
struct Decades {
    int low = 1, high = 0;

    bool empty() const { return low > high; }
    bool holds(int decade) const { return low <= decade && decade <= high; }
};

/// Where a family is measured, and how large its error may be.
struct Demand {
    double tolerance = 1e-5;   // largest error that a picture forgives, for the decades of ordinary scenes
    double bound = 0;          // largest error beyond them
    std::vector<int> decades;  // of x, ascending
    Decades scored{-3, 3};     // those of ordinary scenes

    double allowed(int decade) const { return scored.holds(decade) ? tolerance : bound; }
    int mildest() const;  // the decade from which the sweep starts: of the scored ones, else of all, the nearest to 0
};

/// The greatest error at x; inf: a wrong verdict.
using Measure = std::function<double(double x, Generator&, const Asker&)>;

struct Family {
    std::string name;                    // "far_sphere"
    std::vector<std::string> fragments;  // that it calls; the first one is tested, the others take part
    std::string swept;                   // x, in words: "distance of a sphere / its radius"
    std::string error;                   // what is measured, in words: "error of the hit / its distance"
    Demand demand;
    Measure measure;

    /// A row of a table.
    Family(std::string name_, std::vector<std::string> fragments_, std::string swept_, std::string error_,
           Demand demand_, Measure measure_)
        : name(std::move(name_)),
          fragments(std::move(fragments_)),
          swept(std::move(swept_)),
          error(std::move(error_)),
          demand(std::move(demand_)),
          measure(std::move(measure_)) {}
};

/// All families, in the order of the assignment.
const std::vector<Family>& all_families();

// ---- for those who write families ----

/// low, low + step ... up to high, then more.
std::vector<int> sweep(int low, int high, int step = 1, std::vector<int> more = {});

/// The greater of two errors; a nan, which is never right, counts as inf.
double worse_error(double a, double b);

/// The greatest error of single calls: error(i, outputs).
template <class Error>
double worst_of_rows(const Asker& ask, const std::string& fragment, const Rows& inputs, Error error) {
    const Rows outputs = ask.probe(fragment, inputs);
    double worst = 0;
    for (std::size_t i = 0; i < inputs.size(); ++i) worst = worse_error(worst, error(i, outputs[i]));
    return worst;
}

/// The same in the types of the fragment's declaration: error(result) or error(result, arguments...).
template <auto fragment, class Error>
double worst_of(const Asker& ask, const std::string& name, const Rows& inputs, Error error) {
    return worst_of_rows(ask, name, inputs, [&](std::size_t i, const Row& outputs) -> double {
        return of_call<fragment>(error)(inputs[i], outputs);
    });
}

/// The largest random number below 1 that a sampler can draw, and then some: 1 - 2^-53.
constexpr double almost_one = 1 - 0x1p-53;

/// Midpoints of the n by n cells of the unit square.
std::vector<rt::vec2> grid(int n);

/// A row for each point.
template <class RowAt>
Rows rows_at(const std::vector<rt::vec2>& points, RowAt row_at) {
    Rows rows;
    for (const rt::vec2 u : points) rows.push_back(row_at(u));
    return rows;
}

// one file for each
std::vector<Family> sphere_families();
std::vector<Family> flat_families();
std::vector<Family> mesh_families();
std::vector<Family> leaving_families();
std::vector<Family> light_families();
std::vector<Family> shading_families();
std::vector<Family> glass_families();
std::vector<Family> warp_families();
std::vector<Family> lobe_families();
std::vector<Family> frame_families();
std::vector<Family> camera_families();
std::vector<Family> medium_families();
std::vector<Family> sum_families();
std::vector<Family> picture_families();

}  // namespace grade::stress
