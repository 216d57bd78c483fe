#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assignment/assignment.h"
#include "rt/files/image.h"
#include "statistics/tiles.h"
#include "statistics/verdict.h"

/// The record of a grading: the one source of every report.
namespace grade {

struct StatisticRecord {
    std::string id, what;
    std::optional<double> value, truth, low, high;  // low, high: confidence interval of the value
    double delta0 = 0, tolerance = 0;               // deviations that are still right, that must be found
    bool exact = false;
    int replicates = 0;
    Verdict verdict = Verdict::inconclusive;
    std::string hint;  // where it failed: what the deviation usually means

    /// How much the hint is worth.
    enum class Worth { guess, fact, cause };
    Worth worth = Worth::guess;
    std::string without_numbers{};  // the hint, where a call shows the numbers
    bool chi_squared = false;       // per degree of freedom
};

/// "width of the penumbra, over what must be: 0.5; expected 1"
std::string in_numbers(const StatisticRecord& statistic);

/// What one picture costs, and how far it is from the truth.
struct PictureCost {
    double mse = 0;          // mean over pixels and channels; 0: no noise and no bias. Chance can make it negative
    double cpu_seconds = 0;  // of rendering alone, the fastest of all pictures

    /// 1 / (MSE x CPU time); none where there is no error.
    std::optional<double> efficiency() const;
    double rmse() const;
};

struct CheckRecord {
    std::string name, fragment;
    std::string scene;  // TOML text; empty for a probe
    int samples = 0;    // a pixel
    std::string sampler;
    int share = 1;  // of the fragment's points
    double points = 0, max_points = 0;
    Verdict verdict = Verdict::inconclusive;
    std::string message;  // where there is nothing to measure: what happened, and what to do
    Trouble trouble = Trouble::none;
    std::string excerpt;  // of what the program printed; untrusted
    std::vector<StatisticRecord> statistics;
    double cpu_seconds = 0;
    std::optional<PictureCost> cost, solution_cost;  // of a check that renders

    Tiles tiles;  // of a picture that is shown and fails: where it is wrong

    // for the page only: how the paths of a pixel part from the solution's; untrusted text
    std::string parting;

    // for the page only; drawn: as picture_parts gave them, of a record that has been read again
    rt::Image picture, solution_picture;
    std::string drawn;
};

/// What calls of a fragment show, whichever it is; empty where they show nothing.
struct Finding {
    std::string how;            // "the fragment answers exactly as if it had `u.x` in place of `u.y`"
    std::string where;          // "31 of 96 calls are wrong, those where `dot(n, to_light) < 0`"
    std::string arguments;      // of the simplest call that goes wrong: "camera.size = (2, 2), film = (0, 0)"
    std::string answer, right;  // right: empty where there is more than one
    bool sampled = false;       // other random numbers give answers that are as good
    std::string code;           // the same call in C++; empty: it is too long
    std::string command;        // for a shell: "./grade call moved 'time = -1'"; empty: it cannot be written there
    std::string fault;          // "phong.cpp:24: no value is returned": what sanitizers say of a call; untrusted text

    // Not in the record: what `how` says of answers that are numbers; in which line one change makes all right; whether
    // `where` says which calls; whether a change of arguments, or of a textbook's expression, explains the answers
    // exactly; whether one of the fragment's own expressions makes them right; whether `how` says where nan begins, and
    // nothing else is wrong; CPU time.
    std::string of_numbers{};
    int line = 0;  // 0: unknown
    bool says_which = false, by_arguments = false, by_textbook = false, by_repair = false, of_nan = false;
    bool has_name = false;  // it is a mistake that has one
    double cpu_seconds = 0;
};

struct FragmentRecord {
    std::string name, part;
    double points = 0, max_points = 0;
    std::string visibility = "visible";  // to students; one of the assignment's visibilities
    Verdict verdict = Verdict::inconclusive;
    std::string message;  // what to know about it as a whole; compiler errors are untrusted text
    Trouble trouble = Trouble::none;
    std::string file;    // its path within the submission; empty: there is none
    std::string sha256;  // of its text; likewise
    std::vector<CheckRecord> checks;
    double cpu_seconds = 0;
    bool finished = false;
    Finding finding;
    std::string warnings;  // of the compiler, a line each; untrusted text
    std::string said{};    // of a record that has been read again: what it tells first
};

/// What a grading was made with. Hashes are SHA-256.
struct Provenance {
    std::string version, commit;  // of the grader; commit: what was checked out at its build, if anybody knows
    std::string program,
        reference;  // hashes: the grader itself; what fragments are linked with, its fragments included
    std::string assignment, checks;    // hashes: assignment.toml; what is asked with this seed
    std::string toolchain;             // "GNU 12.2.0, Release"
    std::vector<std::string> flags;    // of the compiler
    std::string built_for, processor;  // the least kind that can run it, empty: any; the one it ran on
};

/// What bounds a grading.
struct GradingLimits {
    double time = 10;    // CPU time of one answer [s]
    int replicates = 0;  // of a statistic, after which it is inconclusive
    int statistics = 0;  // that share the rate of false failures
};

struct Record {
    std::string submission, title;
    std::string student, student_id;  // who handed it in, as a class knows them; empty: its name says
    std::string sha256;               // of the lines "HASH  NAME.cpp" of its fragments
    std::uint64_t seed = 0;
    std::string date;  // when it began, UTC: "2026-01-31T12:00:00Z"
    std::string sandbox, command;
    Provenance provenance;
    GradingLimits limits;
    std::vector<std::string> selection;  // fragments that were asked for; empty: all
    std::vector<Part> parts;
    std::vector<FragmentRecord> fragments;  // in the order of the assignment
    double wall_seconds = 0;
    int reused = 0;  // checks whose records are those of an earlier grading

    // a whole picture, as the submission's fragments draw it and as the solution's do, for the page only
    rt::Image own_picture, own_picture_right;
    std::string own_picture_scene, own_picture_fault;
    bool own_picture_of_some = false;   // of the graded fragments alone, between right ones
    std::vector<std::string> left_out;  // fragments that crash or do not end: their blanks stand in
    double own_picture_exposure = 1;

    std::vector<std::string> notes;    // on the submission as a whole, a line each; untrusted text
    std::vector<std::string> changes;  // since the last grading of the same folder, a line each

    double score() const;
    double max_score() const;
    bool is_complete() const;

    /// The submission's efficiency over the solution's, the median of all pictures with noise of fragments that pass;
    /// none: there are none.
    std::optional<double> efficiency_ratio() const;
};

/// Whether there was no time for a check: its verdict is that of an earlier one.
bool is_not_run(const CheckRecord& check);

/// From bad to good: of two verdicts, the one to tell first.
Verdict worse(Verdict a, Verdict b);

/// Points of a fragment: its share of passed checks, rounded to 2 decimals.
double points_of(const FragmentRecord& fragment);

/// Where calls show the cause, what a deviation usually means would be a second opinion, and a worse one: such
/// statistics say their numbers alone.
void drop_guesses(FragmentRecord& fragment);

/// Shares the fragment's points among its checks, and gives it those of the checks that passed.
void give_points(FragmentRecord& fragment);

}  // namespace grade
