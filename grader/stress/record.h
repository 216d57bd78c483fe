#pragma once

#include <string>
#include <vector>

#include "stress/family.h"

/// What a stress run found: the one source of its table, its page and its JSON.
namespace grade::stress {

struct DecadeRecord {
    int decade = 0;
    double error = 0;     // inf: a wrong verdict, a nan, or no answer
    std::string message;  // why there was no answer
    bool passed = false;
};

/// The decades that pass, on from the mildest without a gap. low > high: not even that one.
using Reach = Decades;

struct FamilyRecord {
    const Family* family;
    bool started = false;               // the fragment is there and builds
    std::string message;                // else: why not
    std::vector<DecadeRecord> decades;  // as in the family
    Reach reach;
    Reach solution;  // of the solution

    bool is_scored() const { return !family->demand.scored.empty(); }
    bool scored_passed() const {
        return is_scored() && !reach.empty() && reach.low <= family->demand.scored.low &&
               reach.high >= family->demand.scored.high;
    }

    /// Decades beyond those of ordinary scenes that pass.
    int bonus() const;
};

/// One of the big counts of a long run.
struct CountRecord {
    std::string name, what;              // "mesh", "rays from within a closed mesh that get out"
    std::vector<std::string> fragments;  // that took part
    double calls = 0, faults = 0;
    double seconds = 0;   // CPU time
    std::string message;  // why it ended early
};

struct StressRecord {
    std::string submission, toolchain, version, command, sandbox;
    std::vector<FamilyRecord> families;
    std::vector<CountRecord> counts;  // of a long run
    double cpu_seconds = 0;           // of the submission's program

    int scored() const;  // families whose ordinary decades all pass
    int most_scored() const;
    int bonus() const;
    int most_bonus() const;  // of the solution
};

/// The decades that pass, on from the mildest of the family.
Reach reach_of(const Family& family, const std::vector<DecadeRecord>& decades);

/// "1e-3 to 1e12", "1e5", "none".
std::string in_words(const Reach& reach);

/// penumbra/stress/v1. What depends on time and load is in keys that end in _seconds, nowhere else.
std::string to_json(const StressRecord& record);

}  // namespace grade::stress
