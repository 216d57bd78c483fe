#include "judging/check_decision.h"

#include <algorithm>

#include "record/record.h"

namespace grade {

CheckDecision::CheckDecision(const Check& check, const Settings& settings)
    : check_(check), judgements_(check.statistics.size()) {
    judges_.reserve(check.statistics.size());
    for (const Statistic& statistic : check.statistics)
        judges_.emplace_back(Tolerance{statistic.delta0, statistic.delta}, settings, statistic.truth);
}

void CheckDecision::add(const Scalars& scalars, const std::function<std::optional<double>(std::size_t)>& exact) {
    for (std::size_t i = 0; i < judges_.size(); ++i) {
        const Statistic& statistic = check_.statistics[i];
        if (statistic.exact) {
            if (first_) {
                const std::optional<double> truth = statistic.truth ? statistic.truth : exact ? exact(i) : std::nullopt;
                judgements_[i] = truth ? judge_exact(scalars(i), *truth, statistic.delta) : Judgement{};
            } else if (statistic.truth && judgements_[i]->verdict == Verdict::passed) {
                judgements_[i] = judge_exact(scalars(i), *statistic.truth, statistic.delta);
            }
        } else if (is_open(i)) {
            judges_[i].add(scalars(i));
            judgements_[i] = judges_[i].decide();
        }
    }
    first_ = false;
}

void CheckDecision::add_reference(const Scalars& scalars) {
    for (std::size_t i = 0; i < judges_.size(); ++i) {
        if (!is_open(i) || check_.statistics[i].truth) continue;
        judges_[i].add_reference(scalars(i));
        judgements_[i] = judges_[i].decide();
    }
}

int CheckDecision::wanted() const {
    int most = 0;
    for (std::size_t i = 0; i < judges_.size(); ++i)
        if (is_open(i)) most = std::max(most, judges_[i].wanted());
    return most;
}

bool CheckDecision::needs_reference() const {
    for (std::size_t i = 0; i < judges_.size(); ++i)
        if (is_open(i) && !check_.statistics[i].truth) return true;
    return false;
}

Verdict CheckDecision::verdict() const {
    Verdict verdict = check_.statistics.empty() ? Verdict::inconclusive : Verdict::passed;
    for (const auto& judgement : judgements_)
        verdict = worse(verdict, judgement ? judgement->verdict : Verdict::inconclusive);
    return verdict;
}

}  // namespace grade
