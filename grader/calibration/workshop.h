#pragma once

#include <functional>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "assignment/assignment.h"
#include "calibration/variant.h"
#include "checks/kit/check.h"
#include "programs/progress.h"
#include "programs/sandbox.h"
#include "programs/toolchain.h"

namespace grade::calibration {

/// How much is measured.
struct Amount {
    int seeds = 4;           // grading seeds, over which the replicates are spread
    int replicates = 4096;   // of each check of each variant, for replays
    int gradings = 300;      // real ones, of whole right submissions
    int wrong_seeds = 3;     // real gradings of each wrong variant
    long draws = 1'000'000;  // replayed gradings of the solution; a tenth for each variant
};

/// What all steps of a calibration share: variants, checks, programs, and the folder where results are kept.
class Workshop {
public:
    /// results  where results are kept: below it a folder for each fragment and state of the sources, so that old
    /// results
    ///          are never taken for new ones, and an edited check costs only its own
    /// words    only variants whose name holds one of them, or whose fragment is one; empty: all
    Workshop(const fs::path& toolchain, const fs::path& results, Amount amount, const std::vector<std::string>& words);

    const Toolchain& chain() const { return chain_; }
    const Assignment& assignment() const { return assignment_; }
    const Sandbox& sandbox() const { return sandbox_; }
    const Amount& amount() const { return amount_; }
    fs::path results(const std::string& fragment = {}) const;
    fs::path meshes() const { return chain_.source / "scenes"; }

    const std::vector<Variant>& variants() const { return variants_; }
    std::vector<const Variant*> variants(Variant::Kind kind) const;

    /// Fragments that are graded: those of the variants that were asked for by name, else all.
    std::set<std::string> fragments() const;

    /// All checks with the parameters of one grading seed; and those of one fragment. They live as long as this.
    const std::vector<Check>& checks(std::uint64_t seed) const;
    std::vector<const Check*> checks(std::uint64_t seed, const std::string& fragment) const;

    /// The text of one of the solution's fragments.
    std::string solution_text(const std::string& fragment) const;

    /// A program that runs this text between the solution's other fragments; linked once for each name. Throws
    /// std::runtime_error where it does not compile.
    fs::path program(const std::string& name, const std::string& fragment, const std::string& text) const;
    fs::path program(const Variant& variant) const;
    fs::path solution_program() const;

private:
    Toolchain chain_;
    Assignment assignment_;
    Sandbox sandbox_;
    Amount amount_;
    fs::path results_;
    std::vector<Variant> variants_;
    bool by_name_;
    mutable std::mutex lock_;
    mutable std::map<std::uint64_t, std::vector<Check>> checks_;
    mutable std::map<std::string, fs::path> folders_;
};

/// One piece of work, whose results are files: done when they are whole.
struct Step {
    std::string name;
    std::vector<fs::path> results;
    std::function<void()> run;
    std::function<bool(const fs::path&)> is_whole = [](const fs::path& result) { return fs::exists(result); };

    bool is_done() const;
};

/// The first half of the calibration: all that is measured by running programs, in the order in which it is worth most.
std::vector<Step> steps_of(const Workshop& workshop);

/// Runs the steps of one shard of several that are not done yet.
///
/// shard  0 to shards - 1
void run_steps(const std::vector<Step>& steps, int shard, int shards, int jobs, const Progress::Listener& progress);

}  // namespace grade::calibration
