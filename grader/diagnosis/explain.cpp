#include "diagnosis/explain.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/changes/small_offsets.h"
#include "diagnosis/forms/asked.h"
#include "diagnosis/forms/where_in_textbook.h"
#include "diagnosis/how.h"
#include "diagnosis/rules/bounds.h"
#include "diagnosis/rules/precision.h"
#include "diagnosis/samples/own_numbers.h"
#include "diagnosis/samples/right_otherwise.h"
#include "diagnosis/samples/spread.h"
#include "diagnosis/source/not_a_number.h"
#include "diagnosis/surest.h"
#include "diagnosis/where/simplest.h"

namespace grade {

namespace {

std::string which(const WrongCalls& region) { return (region.is_exact ? "those " : "") + region.words; }

/// An explanation of one fragment, as it is made.
class Explanation {
public:
    Explanation(const Signature& signature, const Rows& rows, const Ask& ask, const Ask& ask_right)
        : ask_mine_(without_right_ones(signature, rows, ask, ask_right)),
          ask_right_(ask_right),
          all_(compared(signature, rows, mine_, right_)),
          sampled_(
              std::ranges::any_of(signature.arguments, [](const auto& argument) { return argument.name == "u"; })) {
        for (std::size_t k = 0; k < all_.size(); ++k)
            wrong_ += all_.is_wrong(k), not_numbers_ += is_nan(all_.mine[k], all_.right[k]);
    }

    Finding run(const Recompiled& source) {
        const auto in_double = wrong_ > 0 && source.in_double ? source.in_double() : std::nullopt;
        if (in_double) finding_.how = by_double(all_, *in_double);
        if (are_near(all_) && finding_.how.empty()) finding_.how = in_single_precision(all_);
        if (are_near(all_) && finding_.how.empty()) finding_.how = small_offsets(all_);
        if (finding_.how.empty()) finding_.how = starts_on_surface(all_);
        if (wrong_ == 0) return finding_;
        if (!look_for_relation(source)) return {};
        const bool is_nothing = !relation_ || relation_->explains == Relation::Explains::nothing;
        if (is_nothing) broken_ = broken_bound(all_, right_);
        const bool is_rare = broken_ && 20 * broken_->calls.size() < all_.size();  // it may follow from what is in all
        if (is_rare && sampled_ && spread_of(all_, all_, mine_, right_)) broken_.reset();
        if (finding_.how.empty() && !(relation_ && relation_->by_repair))
            if (const InLine reals = by_reals(all_, source.with_reals); !reals.words.empty())
                finding_.how = reals.words, finding_.line = reals.line;
        tell_how();
        tell_what_else_is_broken();
        if (relation_ && relation_->has_other_order)  // then no call by itself is wrong but for what leaves its bounds
            return (broken_ = broken_bound(all_, right_)) ? of_samples() : finding_;
        // Another parametrisation is wrong in no call. Where many answers are the solution's, the random numbers are
        // used as the solution does, but perhaps not in calls of one kind.
        constexpr double many = 0.2;
        const bool is_comparable =
            !sampled_ || not_numbers_ > 0 || double(all_.size() - wrong_) >= many * double(all_.size());
        if (sampled_ && (broken_ ? not_numbers_ == 0 : !is_comparable && !relation_)) return of_samples();
        if (sampled_ && finding_.how.empty())
            finding_.how = spread_of(only_wrong(all_), all_, mine_, right_).value_or("");
        const WrongCalls region = is_comparable ? tell_where(with_parts_that_matter(all_, mine_, right_), wrong_,
                                                             not_numbers_, is_exact(relation_))
                                                : WrongCalls{};
        if (region.is_exact && !region.not_unit.empty() && !is_exact(relation_))
            tell({fmt::format("the length of `{}` is taken to be 1: it may have any", region.not_unit)});
        const bool is_everywhere = !is_nothing && (is_exact(relation_) || relation_->everywhere);
        add_example(region, !sampled_ || is_everywhere || not_numbers_ > 0);
        return finding_;
    }

private:
    void tell(const How& how) {
        finding_.how = how.words, finding_.of_numbers = how.of_numbers, is_elsewhere_ = how.is_elsewhere;
    }

    /// Of samples that are as good as the solution's but for some that are nan. False: there is none.
    bool look_at_nan_alone(const Recompiled& source) {
        relation_.reset(), all_ = only_nan(all_), wrong_ = not_numbers_;
        if (source.editable) editable_ = source.editable();
        return not_numbers_ > 0;
    }

    /// False: other random numbers give these answers.
    bool look_for_relation(const Recompiled& source) {
        depends_ = dependences(all_, all_, mine_, right_);
        for (const Dependence& d : depends_) all_.told.push_back(d.mine > 0 || d.right > 0);
        many_calls_ = crossed(all_, mine_, right_);
        relation_ = surest_relation(many_calls_, ask_mine_, ask_right_, sampled_);
        if (is_no_mistake(relation_)) return look_at_nan_alone(source);
        // that an argument is not used at all says more than two mistakes by which it cancels
        const auto is_unused = [](const Dependence& d) { return d.mine == 0 && d.right > 0.2; };
        if (relation_ && relation_->of_two && std::ranges::any_of(depends_, is_unused)) relation_.reset();
        if (sampled_ && relation_ && tells_of_few(*relation_, all_)) relation_.reset();
        const bool may_be_coarse = finding_.how.empty() && sampled_ && not_numbers_ == 0 && !is_exact(relation_);
        const bool is_coarse = may_be_coarse && !(finding_.how = coarse_spread(all_, mine_, right_)).empty();
        if (source.editable && !is_coarse) {
            const std::string unused = sampled_ ? unused_numbers(all_, depends_) : "";
            editable_ = source.editable();
            if (editable_ && source.more_calls)
                editable_->further = [&] { return compared(all_.signature, source.more_calls(), mine_, right_); };
            add_repair(relation_, all_, editable_, {unused, independence(all_, depends_)});
        }
        finding_.sampled = sampled_, finding_.line = relation_ ? relation_->line_of_repair : 0;
        if (is_exact(relation_)) {
            finding_.by_arguments = relation_->by_arguments, finding_.by_textbook = relation_->by_textbook;
            finding_.by_repair = relation_->by_repair;
            finding_.has_name = relation_->kind == Relation::Kind::named_mistake;
        }
        return true;
    }

    /// How wrong answers come about, where they are not nearly right.
    void tell_how() {
        if (tell_repair_of_spread() || tell_only_nan()) return;
        constexpr double most = 0.9;
        const bool is_nothing = !relation_ || relation_->explains == Relation::Explains::nothing;
        if (finding_.how.empty() && !is_exact(relation_)) finding_.how = in_single_precision(all_);
        const bool is_mostly_known = is_exact(relation_) || (!is_nothing && relation_->share >= most);
        // of a sample, that numbers are not used says more than how it is spread
        if (finding_.how.empty() && sampled_ && not_numbers_ == 0 && !is_mostly_known && !broken_)
            finding_.how = unused_numbers(all_, depends_);
        if (finding_.how.empty()) tell(beside_a_relation(is_mostly_known));
        if (finding_.how.empty() && broken_) finding_.how = broken_->words;
        if (finding_.how.empty() && is_nothing) finding_.how = independence(all_, depends_);
        if (finding_.how.empty() && relation_) tell(how_of(*relation_));
        if (finding_.how.empty()) finding_.how = wrong_answers(all_);
    }

    /// Where nothing else is wrong, where nan begins says more than what it looks like.
    bool tell_only_nan() {
        constexpr double simple = 1.2;  // a change as `safe_sqrt(x)` for `sqrt(x)`
        const bool is_told =
            !finding_.how.empty() || (relation_ && relation_->by_repair && relation_->cost_of_repair <= simple);
        if (not_numbers_ == 0 || not_numbers_ < wrong_ || is_told || !editable_) return false;
        const std::string first = first_not_a_number(all_, *editable_);
        if (!first.empty()) finding_.how = "nan begins with " + first, finding_.of_nan = true, relation_.reset();
        return finding_.of_nan;
    }

    /// Of samples that lie elsewhere than the solution's, what must stand in the source: no call says it.
    bool tell_repair_of_spread() {
        // two changes, or a textbook's, may be the mistake and what makes the numbers be used as the solution does
        const bool is_borrowed = relation_ && relation_->is_borrowed;
        const bool may_be_simpler = is_borrowed || (relation_ && relation_->of_two);
        // a factor, of samples that lie elsewhere, may come from a change that the source tells
        const bool is_factor = is_exact(relation_) && relation_->is_elsewhere && !relation_->has_change();
        // and what no change of the source puts right call by call, the student's own words may still say better
        const bool is_other =
            is_exact(relation_) && relation_->kind == Relation::Kind::change && relation_->line_of_repair == 0;
        const bool is_known =
            !finding_.how.empty() || (!may_be_simpler && ((is_exact(relation_) && !is_factor && !is_other) ||
                                                          (relation_ && relation_->by_repair)));
        if (!sampled_ || is_known || !editable_) return false;
        std::size_t left = 100'000;  // of the solution's answers
        const auto repair = repair_of_spread(all_, *editable_, limited(ask_right_, left));
        constexpr double clearly = 0.5;  // what a textbook has may not stand in the file
        const double dearest = is_other ? relation_->cost + clearly : is_borrowed ? relation_->cost_of_repair : rt::inf;
        if (!repair || repair->cost > dearest) return false;
        finding_.how = broken_ ? broken_->words + "; " + repair->words : repair->words;
        finding_.of_numbers = repair->words, finding_.by_repair = true, finding_.line = repair->line;
        return true;
    }

    /// Where a relation explains a part of the answer alone: what in most of these calls no right answer has.
    void tell_what_else_is_broken() {
        if (sampled_ || not_numbers_ > 0 || !relation_ || relation_->explains != Relation::Explains::some) return;
        const auto broken = broken_bound(all_, right_);
        if (broken && 2 * broken->calls.size() > wrong_) finding_.how = broken->words + "; " + finding_.how;
    }

    /// What says more than a relation that does not explain all.
    How beside_a_relation(bool is_mostly_known) const {
        if (not_numbers_ > 0)
            return is_exact(relation_) ? How{} : of_numbers(picked(many_calls_, most_compared), right_, sampled_);
        if (is_mostly_known) return {};
        if (!sampled_) return {wrong_sums(all_, mine_, right_)};
        return broken_ ? How{} : of_own_numbers(all_, mine_, right_);
    }

    /// Which calls are wrong, or which are no number.
    WrongCalls tell_where(const Calls& all, std::size_t wrong, std::size_t not_numbers, bool is_known) {
        if (not_numbers > 0)
            if (WrongCalls region = region_of(only_nan(all), false); !region.words.empty()) {
                finding_.where = fmt::format("{} of {} calls are nan, {}", not_numbers, all.size(), which(region));
                finding_.says_which = true;
                tell_where_nan_begins();
                return region;
            }
        if (wrong == all.size()) return {};
        WrongCalls region = region_of(all, is_known);
        constexpr double nearly_all = 0.9;  // of the few that are right, what they have in common may be chance
        if (!region.is_exact && double(wrong) > nearly_all * double(all.size())) region = {};
        finding_.where = fmt::format("{} of {} calls are wrong", wrong, all.size());
        if (not_numbers > 0) finding_.where += fmt::format(", {} of them nan", not_numbers);
        if (!region.words.empty()) finding_.where += ", " + which(region);
        finding_.says_which = not_numbers > 0 || !region.words.empty();
        if (not_numbers > 0) tell_where_nan_begins();
        return region;
    }

    void tell_where_nan_begins() {
        const std::string first = editable_ && !finding_.of_nan ? first_not_a_number(all_, *editable_) : "";
        if (!first.empty()) finding_.where += "; nan begins with " + first;
    }

    /// What is wrong with samples that are not the solution's call by call: what no right one does, or how they are
    /// spread.
    Finding of_samples() {
        std::size_t left = most_calls;
        const Ask mine = limited(ask_mine_, left), right = limited(ask_right_, left);
        if (broken_) {
            const std::size_t k = broken_->call;
            const Example example =
                as_printed(all_, {all_.rows[k], all_.mine[k], all_.right[k], 6, all_.told}, mine, right);
            finding_.answer = result_in_words(all_.signature, example.mine);
            add_call(finding_, all_.signature, example);
            Calls known = all_;  // others may be right
            for (std::size_t i = 0; i < all_.size(); ++i)
                if (std::ranges::count(broken_->calls, i) == 0) known.mine[i] = known.right[i];
            tell_where(known, broken_->calls.size(), 0, true);
        } else if (finding_.how.empty()) {
            finding_.how = spread_of(all_, all_, mine, right).value_or("");
        }
        return finding_;
    }

    /// The simplest wrong call. Of a sample there may be more than one right place, unless it is told what is done
    /// otherwise.
    void add_example(const WrongCalls& region, bool is_one_right) {
        std::size_t left = 4000, left_of_own = 400'000;
        if (not_numbers_ > 0) return add_nan_example(region);
        const bool is_form = relation_ && relation_->other_form;
        const bool is_elsewhere = is_elsewhere_ || (relation_ && (relation_->other_numbers || relation_->is_elsewhere));
        const Ask mine = limited(ask_mine_, left),
                  right = is_form        ? answers_of(*relation_->other_form, all_.signature)
                          : is_elsewhere ? at_own_places(all_, mine, limited(ask_right_, left_of_own))
                                         : limited(ask_right_, left);
        Calls all = is_elsewhere || is_form ? picked(all_, most_compared) : all_;
        if (is_elsewhere || is_form) all.right = right(all.rows);
        const Example simplest = simplest_wrong(all, region, mine, right);
        std::vector<bool> wrong_parts;
        bool is_place_wrong = false;
        for (const Field& part : all_.result.parts) {
            wrong_parts.push_back(counts(all_.result, part, simplest.mine, simplest.right) &&
                                  !is_equal(part, simplest.mine, simplest.right));
            is_place_wrong = is_place_wrong || (wrong_parts.back() && is_place(part));
        }
        finding_.answer = result_in_words(all_.signature, simplest.mine, wrong_parts);
        if (is_one_right || !is_place_wrong)
            finding_.right = result_in_words(all_.signature, simplest.right, wrong_parts);
        add_call(finding_, all_.signature, simplest);
    }

    /// The simplest call whose answer is no number.
    void add_nan_example(const WrongCalls& region) {
        std::size_t left = 4000;
        const Ask right = limited(ask_right_, left), any = limited(ask_mine_, left);
        const Ask mine = [&](const Rows& rows) {
            Rows answers = any(rows), due = right(rows);
            for (std::size_t k = 0; k < std::min(answers.size(), due.size()); ++k)
                if (!is_nan(answers[k], due[k])) answers[k] = std::move(due[k]);
            return answers;
        };
        const Example simplest = simplest_wrong(only_nan(all_), region, mine, right);
        finding_.answer = result_in_words(all_.signature, simplest.mine);
        finding_.right = result_in_words(all_.signature, simplest.right);
        add_call(finding_, all_.signature, simplest);
    }

    const Ask ask_mine_;
    const Ask& ask_right_;
    std::size_t left_ = most_calls;
    const Ask mine_ = limited(ask_mine_, left_), right_ = limited(ask_right_, left_);
    Calls all_, many_calls_{};
    bool sampled_, is_elsewhere_ = false;
    std::size_t wrong_ = 0, not_numbers_ = 0;  // calls
    std::vector<Dependence> depends_;
    std::optional<Relation> relation_;
    std::optional<Broken> broken_;
    std::optional<Editable> editable_;
    Finding finding_;
};

}  // namespace

Finding explain(const Signature& signature, const Rows& rows, const Ask& ask, const Ask& ask_right,
                const Recompiled& source) try {
    return Explanation(signature, rows, ask, ask_right).run(source);
} catch (const std::out_of_range&) {
    return {};  // an answer that is too short
}

}  // namespace grade
