#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "calibration/workshop.h"
#include "record/record.h"

namespace grade::calibration {

/// Variants of different fragments in one submission: the grader judges each fragment with the solution's others, so
/// they cannot disturb each other, and what is not changed must pass.
struct Bundle {
    std::string name;  // "wrong-3-1f09"
    std::vector<const Variant*> variants;
};

/// Bundles of variants of one kind that hold each variant once.
///
/// alternate  every other fragment stays the solution's
std::vector<Bundle> bundles(const std::vector<const Variant*>& variants, const std::string& name, bool alternate);

/// What a real grading said about one fragment.
struct RealVerdict {
    std::string fragment;
    Verdict verdict = Verdict::inconclusive;
    std::string message;
    double points = 0, cpu_seconds = 0;  // cpu_seconds: of its checks

    // of what fails: what explains it exactly, whether its hint says where or how, what looking for the cause took
    bool by_arguments = false, by_textbook = false, by_repair = false, by_suspect = false, is_bare = false;
    double diagnosis_seconds = 0;
};

struct RealGrading {
    std::vector<RealVerdict> fragments;
    std::string record;  // a hash of the whole record but for times
};

/// Grades the solution with these changes, once for each seed: compiled once.
///
/// only       fragments to grade; empty: all
/// explained  for so many of the seeds a cause is looked for
std::vector<RealGrading> grade_changed(const Workshop& workshop, const std::map<std::string, std::string>& changed,
                                       const std::vector<std::uint64_t>& seeds, const std::set<std::string>& only,
                                       int jobs, std::size_t explained = std::size_t(-1));

std::map<std::string, std::string> changed_texts(const Bundle& bundle, const Workshop& workshop);

/// As JSON files. Throws std::runtime_error.
void write_grading(const fs::path& path, const RealGrading& grading);
std::optional<RealGrading> read_grading(const fs::path& path);

/// The verdict that the record spells so; inconclusive for a word that is none.
Verdict verdict_named(const std::string& text);

/// Whether a verdict says that a fragment is wrong.
bool is_found(Verdict verdict);

/// Whether the message names the cause: holds one of the words, in any case.
bool says_one_of(const std::string& message, const std::vector<std::string>& words);

}  // namespace grade::calibration
