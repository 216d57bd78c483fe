#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "rt/files/image.h"

/// What the grader asks of a fragment, as data. A check is one experiment on one fragment, and the statistics that are
/// measured in what comes back. How to write one, for a fragment `Color fog(Real extinction, Real way)` of fragments.h:
///
///     #include "asked/fog.h"
///     #include "checks/kit/kit.h"
///
///     namespace grade {
///
///     Checks check_fog(Generator&) {  // it draws what all replicates share, as the place of a scene
///         const auto inputs = rows_of(64, [](Generator& draw) {
///             const double extinction = between(draw, 0.5, 2);
///             return row(extinction, between(draw, 0, 3));
///         });
///         const Statistic share = formula<rt::fog>(
///             {.id = "B1", .what = "share of the light, off by", .tolerance = 1e-4,
///              .right = [](double extinction, double way) { return rt::Color(std::exp(-extinction * way)); },
///              .suspects = {{"the way is not used", [](double s, double) { return rt::Color(std::exp(-s)); }},
///                           {"the absorbed share is returned", [](rt::Color right) { return 1.0 - right; }}}});
///         return {probe_check("attenuation", inputs, {share})};
///     }
///
///     }  // namespace grade
///
/// 1. Ask: probe_check calls the fragment on rows of arguments, render_check draws a scene (kit/scene.h
///    has it from a file or writes it).
/// 2. Judge: formula where each call has one right answer; property where any answer that has it will do; mean_of and
///    uniform_in_square where only the spread of many is known; of_picture for a number of a picture. The id is one of
///    the handout's list of statistics. No argument is an extreme: those are families of grader/stress.
/// 3. Tell: suspects, known values and causes name typical mistakes; try each as a patch in tests/variants/wrong.
///
/// "invalid initialization of reference ... from <brace-enclosed initializer list>": a name after a dot, their order or
/// a function's arguments are not those of the struct. With the struct named, formula(Formula<rt::fog>{...}) or
/// mean_of(Mean{...}), the compiler says which.
namespace grade {

using Row = std::vector<double>;
using Rows = std::vector<Row>;
using Generator = std::mt19937_64;

/// What one run of an experiment gave: an image, and how many rays of each rt::RayKind it took; or the probe's inputs
/// and outputs row by row.
struct Observation {
    rt::Image image;
    std::vector<double> rays{};
    Rows inputs, outputs;
};

/// Calls the fragment on rows of numbers; rows.h says what is in a row.
struct Probe {
    std::string fragment;                    // all_checks fills it in
    std::function<Rows(Generator&)> inputs;  // fresh ones for each replicate
};

/// Renders a scene; each replicate has a seed of its own.
struct Render {
    std::string scene;    // TOML text, its parameters already drawn from the grading seed
    int samples = 16;     // a pixel
    std::string sampler;  // one of sampler_names
    rt::ivec2 size{0};    // [pixel]; 0: the scene's
};

/// What a deviation usually means.
using Hint = std::function<std::string(double value, double truth)>;

/// What one failing observation shows; empty: nothing in particular.
struct Shown {
    Shown(std::string cause = {}) : words(std::move(cause)) {}
    Shown(const char* cause) : words(cause) {}
    Shown(std::string circumstance, std::string worst_call)
        : words(std::move(circumstance)), numbers(std::move(worst_call)) {}

    std::string words, numbers;  // numbers: of a call that is wrong, where nothing tells why

    bool empty() const { return words.empty() && numbers.empty(); }
};
using Cause = std::function<Shown(const Observation&)>;

/// One number measured in an observation, and what it must be.
struct Statistic {
    std::string id;                                     // of the list in the handout: "L3"
    std::string what;                                   // "penumbra width [pixel]"
    std::function<double(const Observation&)> measure;  // one replicate's scalar
    std::optional<double> truth;                        // closed form; none: the solution's own replicates
    double delta0 = 0;                                  // deviation that is still right, same unit
    double delta = 0;                                   // deviation that must be found
    bool exact = false;                                 // without noise: one replicate decides, |deviation| <= delta
    Hint hint;
    Cause cause{};              // what it tells comes before the hint
    bool hint_is_fact = false;  // true of what was measured, whatever the mistake is
    bool chi_squared = false;   // per degree of freedom
};

struct Check {
    std::string name;      // "penumbra_width"
    std::string fragment;  // whose points it decides; all_checks fills it in
    std::variant<Probe, Render> experiment;
    std::vector<Statistic> statistics;
    int share = 1;  // of the fragment's points
};

using Checks = std::vector<Check>;

/// All checks, in the order of the assignment, those of fragments that it leaves out last, with the parameters that the
/// grading seed draws.
std::vector<Check> all_checks(std::uint64_t seed);

/// Those of one fragment; none: there is no fragment of this name.
std::vector<Check> checks_of(const std::string& fragment, std::uint64_t seed);

}  // namespace grade
