#pragma once

#include <optional>
#include <span>

#include "diagnosis/changes/relation.h"
#include "diagnosis/forms/asked.h"

namespace grade {

/// Looks for mistakes in one form; the right answers are the form's.
class FormSearch {
public:
    static constexpr double dearest_of_pairs = 1.3;  // cost of a mistake

    /// left: answers that it may ask for.
    FormSearch(const Calls& calls, Asked& asked, std::size_t& left);

    std::size_t wrong() const { return wrong_.size(); }

    /// Whether any answer tells a mistake from others: that nothing is ever hit may have many reasons.
    bool tells() const;

    /// Whether a part of the answers is right in most wrong calls.
    bool has_right_part() const;

    /// The simplest mistake that explains all, or the one that explains most of what is wrong.
    std::optional<Relation> one(bool or_of_arguments = false, double dearest = rt::inf);

    /// Two mistakes that explain all.
    std::optional<Relation> two();

private:
    /// Those of expressions and those of arguments, the simplest first.
    std::vector<Mistake> mistakes_and(const std::vector<Change>& changes);

    /// Of operators and functions that nothing tells apart, the first two are told: they stand in different places.
    Relation or_another(Relation found, std::span<const Mistake> mistakes);

    bool are_in_one_place(const Mistake& a, const Mistake& b) const;
    bool explains(std::size_t k, const Mistake& first, const Mistake* second = nullptr);

    /// Whether it explains the first or the second call that it can change.
    bool may_explain(const Mistake& mistake);

    /// Whether the form computes one of its expressions in a call of the sample.
    bool is_computed(std::size_t i, const Mistake& mistake) const;

    bool changes_an_answer(const Mistake& mistake);

    /// Of the wrong calls; 0 where it breaks a right one.
    double share_of(const Mistake& mistake);

    /// Whether the wrong calls, too few for pairs of changes, tell hits from misses alone.
    bool are_hits_alone() const;
    bool explain_all(const Mistake& first, const Mistake& second);

    Relation relation(const Mistake& mistake, double share) const;

    const Calls& calls_;
    Asked& asked_;
    std::size_t& left_;
    std::vector<std::size_t> wrong_, sample_;
    std::vector<std::vector<bool>> computed_;  // by call of the sample, by node
};

}  // namespace grade
