#pragma once

#include <string>
#include <vector>

#include "calibration/nominal.h"
#include "calibration/peers.h"
#include "calibration/real.h"
#include "calibration/replay.h"
#include "calibration/workshop.h"

namespace grade::calibration {

/// What the results say about one variant.
struct VariantSummary {
    const Variant* variant = nullptr;
    int gradings = 0, found = 0, open = 0,
        named = 0;                   // real ones: wrong verdict, inconclusive, cause in the first hint
    std::vector<RealVerdict> hints;  // of the real ones that found it
    Tally replayed;                  // of its own fragment
    double fixed_seconds = 0;        // what a fixed number of replicates of the same power would cost
    int pictures = 0;                // that the rules of others were shown
    PeerRules peers;                 // true: they pass it
};

/// The verdicts with a given number of replicates: the most that may be spent on a statistic, or a fixed number.
struct Budget {
    int replicates = 0;
    Tally right, wrong;      // the whole solution; one fragment of each wrong variant
    double worst_wrong = 0;  // largest share of wrong verdicts of one variant
    std::string worst;
};

struct Dose {
    const Variant* variant;
    std::vector<std::pair<std::string, double>> found;  // share of gradings that find this size
};

struct Confined {
    const Variant* variant;
    int changed = 0, pixels = 0, gradings = 0, found = 0;
};

/// All that a calibration has found out, from what is there.
struct Summary {
    int steps = 0, steps_done = 0;
    int least_replicates = 0;  // of a statistic of a variant, in the stores
    int noisy = 0;             // statistics that share alpha
    Tally solution;            // replayed gradings of the whole solution
    std::vector<VariantSummary> right, wrong;
    int right_gradings = 0, right_failures = 0, right_open = 0;  // real ones of whole submissions
    std::vector<std::string> false_failures;                     // what and why
    int neighbours = 0, spoiled = 0;                             // fragments beside a changed one, in real gradings
    std::vector<Nominal> nominal;
    std::vector<Budget> budgets, fixed_budgets;
    std::vector<Dose> doses;
    std::vector<Confined> confined;
    int under_load = 0, same_under_load = 0;
    double whole_seconds = 0;  // CPU of the checks of one right submission, real
};

/// The second half of the calibration: replays, and all that the stored results say.
Summary summarize(const Workshop& workshop, int jobs, const Progress::Listener& progress);

/// Bounds of a rate of which `hits` were seen in `all`, 95 %.
///
/// Source: Clopper and Pearson, "The use of confidence or fiducial limits...", Biometrika 26, 1934.
std::pair<double, double> rate_bounds(long hits, long all);

}  // namespace grade::calibration
