#pragma once

#include <optional>

#include "build/runner.h"
#include "convergence/measure.h"
#include "rt/scene.h"

namespace grade {

/// The size at which a scene is measured.
rt::ivec2 size_of(const rt::Scene& scene, int side);

/// The seed of a replicate of a level; of level 0: of a half of the reference.
std::uint64_t seed_of(int samples, int replicate);

/// One picture, or why there is none, or why it is none.
Outcome<rt::Image> picture(Runner& runner, const Render& render, std::uint64_t seed);

/// The two halves of a scene's reference, rendered with twice the most samples each, or what is kept of them. None: the
/// submission's program, which must make them where there is no solution, breaks down; record.fault says how. Throws
/// std::runtime_error where the solution does.
std::optional<Halves> reference_of(const fs::path& scene, const Bench& bench, const Amounts& amounts,
                                   SceneRecord& record);

}  // namespace grade
