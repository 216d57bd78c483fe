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
/// measured in what comes back.
namespace grade {

using Row = std::vector<double>;
using Rows = std::vector<Row>;
using Generator = std::mt19937_64;

/// What one run of an experiment gave: an image, or the probe's inputs and outputs row by row.
struct Observation {
    rt::Image image;
    Rows inputs, outputs;
};

/// Calls the fragment on rows of numbers; probes.h says what is in a row.
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

/// One number measured in an observation, and what it must be.
struct Statistic {
    std::string id;                                          // of the list in the handout: "L3"
    std::string what;                                        // "penumbra width [pixel]"
    std::function<double(const Observation&)> measure;       // one replicate's scalar
    std::optional<double> truth;                             // closed form; none: the solution's own replicates
    double delta0 = 0;                                       // deviation that is still right, same unit
    double delta = 0;                                        // deviation that must be found
    bool exact = false;  // without noise: one replicate decides, |deviation| <= delta
    std::function<std::string(double value, double truth)> hint;  // what a deviation usually means
    std::function<std::string(const Observation&)> cause{};       // what one failing observation shows; empty: ask hint
};

struct Check {
    std::string name;      // "penumbra_width"
    std::string fragment;  // whose points it decides; all_checks fills it in
    std::variant<Probe, Render> experiment;
    std::vector<Statistic> statistics;
    int share = 1;  // of the fragment's points
};

using Checks = std::vector<Check>;

/// All checks, in the order of the assignment, with the parameters that the grading seed draws.
std::vector<Check> all_checks(std::uint64_t seed);

/// Those of one fragment.
std::vector<Check> checks_of(const std::string& fragment, std::uint64_t seed);

}  // namespace grade
