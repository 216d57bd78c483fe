#pragma once

#include <functional>

#include "convergence/record.h"
#include "programs/sandbox.h"
#include "rt/scene.h"

namespace grade::convergence {

/// Of a level that the budget cuts short.
constexpr int least_replicates = 4;

/// How much is measured.
struct Amounts {
    std::vector<int> samples{1, 4, 16, 64, 256, 1024};  // a pixel, ascending
    // blue_noise errs as sobol does, pixel by pixel
    std::vector<std::string> samplers{rt::sampler_names.begin(), std::prev(rt::sampler_names.end())};
    int replicates = 8;      // of each level; the last one may have less
    int side = 48;           // pixels of the longer side of a picture; 0: as the scene has it
    double budget = 60;      // CPU seconds of rendering, all scenes together, without the references
    double time_limit = 60;  // CPU seconds of one picture
};

/// The programs that are compared, and where results are kept.
struct Bench {
    fs::path submission, solution;  // programs; no submission: the solution alone
    std::string submission_stamp, solution_stamp;
    Sandbox sandbox;
    fs::path results;                                                     // folder
    bool fresh = false;                                                   // measure anew what is there
    std::function<fs::path(const fs::path& program)> copy;                // into a folder of its own
    std::function<void(double done, const std::string& doing)> progress;  // done: share of this scene's work
};

/// Errors and CPU times of one scene, level by level, all samplers and both programs in turn, until all levels are done
/// or the budget is spent; goes on from what is kept. A level that is not begun needs less of the budget than there is
/// left. Throws rt::InputError for a scene that is none, std::runtime_error where the solution breaks down.
SceneRecord measure(const fs::path& scene, const Bench& bench, const Amounts& amounts, double budget);

}  // namespace grade::convergence
