#pragma once

#include <array>
#include <string_view>

namespace grade {

/// How a statistic, a check or a fragment came out.
enum class Verdict {
    passed,
    failed,
    not_started,  // still the blank
    did_not_build,
    crashed,
    timed_out,
    not_finite,    // NaN or infinity
    inconclusive,  // neither right nor wrong within the budget: for the instructor to look at
};

/// What is behind a verdict that no statistic gives.
enum class Trouble {
    none,
    keeps_state,  // the same arguments give another answer
    not_a_number,
    no_radiance,  // numbers, but no picture of light
    not_run,      // an earlier check of the fragment timed out
    missing,      // the submission has no file of this fragment, nor one that may be meant
    endless,      // one answer has taken all of its time
};

constexpr std::array<std::string_view, 8> verdict_names = {"passed",  "failed",    "not_started", "did_not_build",
                                                           "crashed", "timed_out", "not_finite",  "inconclusive"};

constexpr std::array<std::string_view, 7> trouble_names = {"none",    "keeps_state", "not_a_number", "no_radiance",
                                                           "not_run", "missing",     "endless"};

/// As the record spells them.
constexpr std::string_view name(Verdict verdict) { return verdict_names[static_cast<std::size_t>(verdict)]; }
constexpr std::string_view name(Trouble trouble) { return trouble_names[static_cast<std::size_t>(trouble)]; }

}  // namespace grade
