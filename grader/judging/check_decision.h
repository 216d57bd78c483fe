#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "checks/kit/check.h"
#include "statistics/engine.h"

namespace grade {

/// Decides on a check from the scalars of its replicates, wherever these come from: a program that runs, or a store.
class CheckDecision {
public:
    /// One scalar of a replicate, by the statistic's place in the check.
    using Scalars = std::function<double(std::size_t statistic)>;

    /// alpha is shared by all statistics of the assignment.
    CheckDecision(const Check& check, const Settings& settings);

    /// The submission's next replicate. The first one decides what has no noise; where later ones are needed for the
    /// rest, what has a closed form must hold in them as well.
    ///
    /// exact  the solution's scalars in this replicate, asked for where a statistic without noise has no closed form;
    ///        none: not known
    void add(const Scalars& scalars, const std::function<std::optional<double>(std::size_t statistic)>& exact = {});

    /// The solution's next replicate, for statistics without closed form.
    void add_reference(const Scalars& scalars);

    /// How many replicates there must be in all before more can be said; 0: everything is decided.
    int wanted() const;

    /// Whether an open statistic compares with the solution's replicates.
    bool needs_reference() const;

    /// Of each statistic; all are there when nothing more is wanted.
    const std::vector<std::optional<Judgement>>& judgements() const { return judgements_; }

    /// The worst of them; inconclusive for a check without statistics.
    Verdict verdict() const;

private:
    bool is_open(std::size_t i) const { return !judgements_[i]; }

    const Check& check_;
    std::vector<Judge> judges_;
    std::vector<std::optional<Judgement>> judgements_;
    bool first_ = true;
};

}  // namespace grade
