#pragma once

#include "convergence/measure.h"
#include "programs/runner.h"
#include "rt/scene.h"

namespace grade::convergence {

/// The size at which a scene is measured.
rt::ivec2 size_of(const rt::Scene& scene, int side);

/// The seed of a replicate of a level; of level 0: of a half of the reference.
std::uint64_t seed_of(int samples, int replicate);

/// One picture, or why there is none, or why it is none.
Outcome<rt::Image> picture(Runner& runner, const Render& render, std::uint64_t seed);

/// The last level that the budget allows, as far as can be foreseen: at least `least_replicates` of it.
///
/// seconds  CPU time of one sample a pixel, of one sampler of one program
/// series   samplers times programs
int last_level(const Amounts& amounts, double budget, double seconds, int series);

/// The two halves of a scene's reference, or what is kept of them. Each has four times the samples of the last level
/// that the budget allows, as a small picture foretells: its noise then makes the errors of that level uncertain by a
/// few percent at most, and biases none. Throws std::runtime_error where the solution breaks down.
Halves reference_of(const fs::path& scene, const Bench& bench, const Amounts& amounts, double budget,
                    SceneRecord& record);

}  // namespace grade::convergence
