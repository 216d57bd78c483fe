#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "convergence/compare.h"
#include "convergence/fit.h"
#include "rt/math.h"

/// What `grade converge` has measured: the one source of its table, plots, JSON and CSV.
namespace grade::convergence {

/// One picture.
struct Run {
    double mse = 0, relative = 0;  // against the reference
    double cpu_seconds = 0;        // of rendering alone
    double rays = 0;               // of all kinds
};

/// All pictures with one number of samples a pixel, by replicate.
struct Level {
    int samples = 0;
    std::vector<Run> runs;

    double mse() const;  // means over the replicates
    double relative() const;
    double rays() const;
    double seconds() const;  // median
    double efficiency() const { return 1 / (mse() * seconds()); }

    /// 95 % interval of the MSE; both 0 for a single replicate.
    std::pair<double, double> mse_interval() const;
};

enum class Who { submission, solution };
const char* name(Who who);

/// One sampler of one program.
struct Curve {
    Who who = Who::solution;
    std::string sampler;
    std::vector<Level> levels;
    std::optional<Estimate> bias;  // squared; none: the pattern has no randomness to average over
    Fit fit;

    std::vector<LevelErrors> errors() const;

    /// The path of one replicate through all levels that have it.
    std::vector<Waypoint> path(std::size_t replicate) const;

    /// CPU seconds to an error as small as that, the mean of the replicates.
    std::optional<Ratio> seconds_for(double mse) const;
};

/// Submission over solution, for one sampler.
struct Comparison {
    std::string sampler;
    std::optional<Ratio> mse_at_equal_time;             // at the CPU time of the solution's last level
    std::array<std::optional<Ratio>, 2> time_at_error;  // to each of the two errors
};

struct SceneRecord {
    std::string name, file;
    rt::ivec2 size{0};
    int reference_samples = 0;                    // of each half
    double reference_noise = 0;                   // RMSE of both together
    std::array<std::optional<double>, 2> errors;  // MSE of 64 and of 1024 independent samples
    std::vector<Curve> curves;
    std::vector<Comparison> comparisons;
    std::string fault;  // of the submission's program: why there are no curves, or none further

    const Curve* find(Who who, const std::string& sampler) const;

    /// The curve with the largest bias that is shown, of the submission where there is one; none: none is.
    const Curve* biased() const;
};

/// Independent samples whose error is one to be reached.
constexpr std::array<int, 2> independent_samples{64, 1024};

struct ConvergenceRecord {
    std::string submission, note, toolchain, version, command, sandbox;
    std::vector<SceneRecord> scenes;

    bool is_biased() const;
};

/// Fits, errors to be reached, and comparisons, from the curves' levels.
void analyse(SceneRecord& scene);

/// Slopes that theory expects of the RMSE against the samples: on an edge in two dimensions, and for a smooth function.
/// None: there is no such law.
struct ExpectedOrder {
    const char* sampler;
    std::optional<double> edge, smooth;
};

/// Source: Mitchell, "Consequences of Stratified Sampling in Graphics", SIGGRAPH 1996; Owen, "Scrambled Net Variance
/// for Integrals of Smooth Functions", Ann. Statist. 25(4), 1997.
const std::vector<ExpectedOrder>& expected_orders();

/// "-0.50", "-0.75 to -1.00", "any".
std::string expected_order(const std::string& sampler);

/// penumbra/convergence/v1.
std::string to_json(const ConvergenceRecord& record);

/// One line for each level of each curve.
std::string to_csv(const ConvergenceRecord& record);

}  // namespace grade::convergence
