#pragma once

#include <optional>
#include <vector>

#include "statistics/moments.h"
#include "statistics/verdict.h"

namespace grade {

/// A deviation up to delta0 is legitimate, one of delta must be found; in the statistic's own unit.
struct Tolerance {
    double delta0 = 0;
    double delta = 0;
};

struct Settings {
    double alpha = 1e-4;  // probability that a right submission fails, over all its statistics
    int statistics = 1;   // how many statistics share alpha
    double beta = 1e-3;   // probability that a deviation of delta passes
    int cap = 256;        // replicates, after which a statistic is inconclusive
};

/// What became of one statistic.
struct Judgement {
    Verdict verdict = Verdict::inconclusive;  // passed, failed or inconclusive
    double value = 0, truth = 0;
    double se = 0;             // standard error of value - truth
    double low = 0, high = 0;  // confidence interval of the value, at 1 - beta on either side
    int replicates = 0;
    bool constant = false;  // the submission's replicates were all equal
};

/// Decides between right and wrong from replicates, as soon as it is certain.
///
/// Replicates are scalars of independent renders; they are looked at when there are 8, 16, 32, 64, 96... of them:
///
///     passed  when |m| + t(1 - beta_k) se <= delta          equivalence: the deviation m is shown to be small
///     failed  when (|m| - delta0) / se > t(1 - alpha_k / 2) twice: in all replicates so far, and then in as many
///             fresh ones, on the same side
///
/// where t are quantiles of Student's distribution, and the alpha_k and beta_k of all looks add up to alpha and beta. A
/// failure needs 16 replicates, since means of fewer are not normal enough; only a gross one is seen with 8: all of
/// them beyond delta on the same side, 20 standard deviations away, and 8 fresh ones again. Equal replicates are
/// compared as they are. With no decision at the cap the verdict is inconclusive.
///
/// Source: Schuirmann, "A comparison of the two one-sided tests procedure...", J. Pharmacokin. Biopharm. 15, 1987;
/// Welch, "The generalization of Student's problem...", Biometrika 34, 1947.
class Judge {
public:
    /// truth  closed form; none: the mean of the reference's replicates, one for each of the submission's
    Judge(Tolerance tolerance, Settings settings, std::optional<double> truth = std::nullopt);

    void add(double replicate);
    void add_reference(double replicate);

    /// The verdict on the replicates so far; none: more are needed. Once there, it does not change any more.
    std::optional<Judgement> decide() const { return judgement_; }

    /// How many replicates there must be in all before decide() can say more than it does now.
    int wanted() const { return wanted_; }

private:
    struct Comparison;  // of a range of replicates with the truth
    Comparison compare(int first, int last) const;
    bool fails(const Comparison& c, double tail) const;
    bool is_gross(const Comparison& c) const;
    void advance();  // takes every look for which there are replicates
    void look_at();  // one of them
    void confirm();  // or at the fresh replicates
    void next(int look);
    void judge(Verdict verdict, const Comparison& c);

    Tolerance tolerance_;
    Settings settings_;
    std::optional<double> truth_;
    std::vector<double> own_, reference_;

    bool waits_for_confirmation() const { return wanted_ > look_; }

    int look_, wanted_;  // wanted_ is twice look_ while a failure waits for its confirmation
    double beta_left_;   // not spent yet
    double screen_tail_, confirm_tail_;
    std::optional<Judgement> judgement_;
};

/// The verdict on a statistic without noise: passed when |value - truth| <= delta.
Judgement judge_exact(double value, double truth, double delta);

}  // namespace grade
