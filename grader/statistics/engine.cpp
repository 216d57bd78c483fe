#include "statistics/engine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "statistics/distributions.h"
#include "statistics/tests.h"

namespace grade {

namespace {

constexpr int first_look = 8, first_failure = 16, stride = 32;
constexpr double gross = 20;  // standard deviations

int next_look(int look) { return look < stride ? 2 * look : look + stride; }

/// Looks at which a failure can be found.
int failing_looks(int cap) {
    int count = 0;
    for (int look = first_failure; look <= cap; look = next_look(look)) ++count;
    return std::max(count, 1);
}

}  // namespace

struct Judge::Comparison {
    int replicates;
    double value, truth;
    double deviation;  // value - truth
    double se, degrees;
    double spread;          // standard deviation of a replicate
    double least;           // the smallest deviation of a replicate, counted towards the mean's side
    bool finite, constant;  // constant: own replicates all equal
};

Judge::Judge(Tolerance tolerance, Settings settings, std::optional<double> truth)
    : tolerance_(tolerance),
      settings_(settings),
      truth_(truth),
      look_(first_look),
      wanted_(first_look),
      beta_left_(settings.beta) {
    const double each = std::sqrt(settings.alpha / settings.statistics);  // of screening, and again of confirming
    screen_tail_ = each / failing_looks(settings.cap) / 2;
    confirm_tail_ = each / 2;
}

void Judge::add(double replicate) {
    own_.push_back(replicate);
    advance();
}

void Judge::add_reference(double replicate) {
    reference_.push_back(replicate);
    advance();
}

Judge::Comparison Judge::compare(int first, int last) const {
    const auto range = [&](const std::vector<double>& all) { return std::span(all).subspan(first, last - first); };
    const auto own = range(own_);
    const Moments moments = moments_of(own);

    Comparison c{};
    c.replicates = last - first;
    c.value = moments.mean;
    c.spread = moments.deviation();
    c.constant = moments.m2 == 0;
    if (truth_) {
        c.truth = *truth_;
        c.se = moments.standard_error();
        c.degrees = moments.count - 1;
    } else {
        const Moments reference = moments_of(range(reference_));
        const Welch welch = welch_test(moments, reference);
        c.truth = reference.mean;
        c.se = welch.se;
        c.degrees = welch.degrees;
        c.spread = std::max(c.spread, reference.deviation());
    }
    c.deviation = c.value - c.truth;
    c.finite = std::isfinite(c.deviation) && std::isfinite(c.se);

    const double side = c.deviation < 0 ? -1 : 1;
    c.least = std::numeric_limits<double>::infinity();
    for (double x : own) c.least = std::min(c.least, side * (x - c.truth));
    return c;
}

bool Judge::fails(const Comparison& c, double tail) const {
    const double excess = std::abs(c.deviation) - tolerance_.delta0;
    return excess > 0 && excess > student_quantile(c.degrees, tail) * c.se;
}

bool Judge::is_gross(const Comparison& c) const {
    return c.least > tolerance_.delta && std::abs(c.deviation) - tolerance_.delta > gross * c.spread;
}

void Judge::judge(Verdict verdict, const Comparison& c) {
    const double reach = c.se > 0 ? student_quantile(c.degrees, settings_.beta) * c.se : 0;
    judgement_ = {verdict, c.value, c.truth, c.se, c.value - reach, c.value + reach, c.replicates, c.constant};
}

void Judge::advance() {
    const int have = int(truth_ ? own_.size() : std::min(own_.size(), reference_.size()));
    while (!judgement_ && have >= wanted_) waits_for_confirmation() ? confirm() : look_at();
}

void Judge::look_at() {
    const Comparison all = compare(0, look_);
    if (!all.finite) return judge(Verdict::failed, all);

    // equal replicates
    if (all.se == 0) {
        const bool right = std::abs(all.deviation) <= std::max(tolerance_.delta0, tolerance_.delta);
        return judge(right ? Verdict::passed : Verdict::failed, all);
    }

    // shown to be right
    beta_left_ /= 2;
    if (std::abs(all.deviation) + student_quantile(all.degrees, beta_left_) * all.se <= tolerance_.delta)
        return judge(Verdict::passed, all);

    // looks wrong: is it, in fresh replicates?
    if (look_ < first_failure ? is_gross(all) : fails(all, screen_tail_))
        wanted_ = 2 * look_;
    else
        next(next_look(look_));
}

void Judge::confirm() {
    const Comparison all = compare(0, look_), fresh = compare(look_, 2 * look_);
    const bool same_side = (fresh.deviation < 0) == (all.deviation < 0);
    if (!fresh.finite || (same_side && (look_ < first_failure ? is_gross(fresh) : fails(fresh, confirm_tail_))))
        return judge(Verdict::failed, compare(0, 2 * look_));
    next(2 * look_);
}

void Judge::next(int look) {
    if (look > settings_.cap) return judge(Verdict::inconclusive, compare(0, look_));
    look_ = wanted_ = look;
}

Judgement judge_exact(double value, double truth, double delta) {
    const bool right = std::abs(value - truth) <= delta;  // false for a NaN
    return {right ? Verdict::passed : Verdict::failed, value, truth, 0, value, value, 1, true};
}

}  // namespace grade
