#pragma once

#include "checks/kit/check.h"
#include "programs/runner.h"

namespace grade {

/// What a replicate's random numbers are drawn for.
enum class Stream : std::uint64_t { submission = 1, reference = 2 };

/// What tells a check from all others: "hit_sphere.inside".
std::string key_of(const Check& check);

/// The seed of one replicate of a check: of its own for each, and the same again for the same grading seed.
std::uint64_t replicate_seed(std::uint64_t grading_seed, const Check& check, Stream stream, int replicate);

/// Runs a check's experiment once. A fault where nothing can be measured in what comes back.
Outcome<Observation> observe(Runner& runner, const Check& check, std::uint64_t seed);

/// Whether two observations agree bit by bit.
bool is_same(const Observation& a, const Observation& b);

/// Whether two observations differ by more than rounding: by more than a millionth of a number.
bool differs(const Observation& a, const Observation& b);

/// A statistic of an observation; nan where it cannot be measured.
double measured(const Statistic& statistic, const Observation& observation);

}  // namespace grade
