#include "diagnosis/source/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "diagnosis/rules/precision.h"
#include "diagnosis/source/edited_calls.h"
#include "diagnosis/source/edits_in_words.h"
#include "diagnosis/source/effect.h"
#include "diagnosis/source/renamed.h"

namespace grade {

namespace {

constexpr double least_share = 0.9;                          // of the wrong calls
constexpr double dearest_alone = 1.5, dearest_of_two = 1.3;  // of one that puts most right; of each of two

class Repairs : private EditedCalls {
public:
    Repairs(const Calls& calls, const Editable& source) : EditedCalls(calls, source) {}

    std::optional<Repair> run(bool only_one) {
        if (wrong_.size() < enough_wrong || !see()) return std::nullopt;
        const std::vector<Mistake> changes = mistakes_in(all_, arguments_, told_);
        std::vector<Edit> one = alone(changes);
        auto repair = of_all(one);
        if (!repair) repair = of_all(renamed(all_, changes));
        constexpr double odd = 1.6;
        // answers that are nearly right, or mostly, lack digits, not an expression
        if ((!repair || repair->cost > odd) && !are_near(calls_) && 4 * calls_.wrong().size() > calls_.size()) {
            const std::vector<Mistake> borrowing = with_borrowed();
            auto other = of_all(alone(borrowing));
            if (other) other->is_borrowed = true, other->is_simple = false;
            if (other && (!repair || other->cost < repair->cost)) repair = other;
        }
        if (repair || only_one) return repair;
        if ((repair = of_all(two(changes)))) return repair;
        // samples that lie elsewhere may be as good: most of them say nothing
        const bool sampled =
            std::ranges::any_of(calls_.signature.arguments, [](const auto& argument) { return argument.name == "u"; });
        return sampled ? std::nullopt : of_most(one);
    }

private:
    static std::vector<Edit> alone(const std::vector<Mistake>& changes) {
        std::vector<Edit> all;
        for (const Mistake& change : changes) all.push_back({&change});
        return all;
    }

    Effect effect_on_further(const Edit& edit) {
        if (!further_) further_ = source_.further ? source_.further() : Calls{};
        Rows rows;
        for (std::size_t k = 0; k < further_->size(); ++k)
            rows.push_back(textbook::row_of(call(*further_, k, false), &edit.first->made,
                                            edit.second ? &edit.second->made : nullptr));
        return effect_on(*further_, rows.empty() ? Rows() : source_.ask(rows));
    }

    /// Whether all further calls are right with it.
    bool holds(const Edit& edit) { return effect_on_further(edit).is_all_right(); }

    /// visit(i, whether the call is right with edits[i]); false: no more may be asked.
    template <class Visit>
    bool try_all(const std::vector<Edit>& edits, std::size_t k, Visit visit) {
        const textbook::EditedCall as_it_is = call(calls_, k, false);
        for (std::size_t from = 0; from < edits.size(); from += most_at_once) {
            const std::size_t to = std::min(edits.size(), from + most_at_once);
            Rows rows;
            for (std::size_t i = from; i < to; ++i)
                rows.push_back(textbook::row_of(as_it_is, &edits[i].first->made,
                                                edits[i].second ? &edits[i].second->made : nullptr));
            asked_ += rows.size();
            if (asked_ > most_rows) return false;
            const Rows answers = source_.ask(rows);
            const bool has_answers = answers.size() == rows.size();  // else one of them ends the program
            for (std::size_t i = from; i < to; ++i) visit(i, has_answers && is_right(k, answers[i - from]));
        }
        return true;
    }

    /// Those with which the call is right.
    std::vector<Edit> right_in(const std::vector<Edit>& edits, std::size_t k) {
        std::vector<Edit> kept;
        const bool all = try_all(edits, k, [&](std::size_t i, bool is) {
            if (is) kept.push_back(edits[i]);
        });
        return all ? kept : std::vector<Edit>();
    }

    /// The simplest one with which all calls are right.
    std::optional<Repair> of_all(std::vector<Edit> edits) {
        for (const auto* some : {&wrong_, &right_, &others_})  // most change no wrong answer
            for (const std::size_t k : *some)
                if (edits = right_in(edits, k); edits.empty()) return std::nullopt;
        // the order of those that cost the same stays
        std::ranges::stable_sort(edits, {}, &Edit::cost);
        constexpr std::size_t most = 16;  // of which further calls are asked
        if (edits.size() > most) edits.resize(most);
        std::erase_if(edits, [this](const Edit& edit) { return !holds(edit); });
        if (edits.empty()) return std::nullopt;
        const Edit& best = edits.front();
        constexpr double simple = 1.6;
        return Repair{in_words(all_, best) + or_elsewhere(edits, best) + ", every answer is right",
                      line_of(all_, best),
                      1,
                      best.cost() <= simple,
                      best.second != nullptr && !best.in_one_expression,
                      is_literal(best.first->made) && best.first->pattern != "{1}",
                      false,
                      best.cost()};
    }

    /// ", or ..." what costs as little in another line.
    std::string or_elsewhere(const std::vector<Edit>& edits, const Edit& best) const {
        const auto is_other = [&](const Edit& edit) {
            return !edit.second && edit.cost() == best.cost() && line_of(all_, edit) != line_of(all_, best);
        };
        const auto other = best.second ? edits.end() : std::ranges::find_if(edits, is_other);
        return other == edits.end() ? "" : ", or " + in_words(all_, *other);
    }

    /// The one with which most of the wrong calls are right, and all others stay so.
    std::optional<Repair> of_most(const std::vector<Edit>& edits) {
        constexpr std::size_t few = 6;
        std::vector<Edit> some;
        std::ranges::copy_if(edits, std::back_inserter(some),
                             [](const Edit& edit) { return edit.cost() <= dearest_alone; });
        std::vector<std::size_t> count(some.size());
        for (std::size_t i = 0; i < few; ++i)
            try_all(some, wrong_[i * wrong_.size() / few], [&](std::size_t e, bool is) { count[e] += is; });
        std::size_t e = 0;
        std::erase_if(some, [&](const Edit&) { return 2 * count[e++] < few; });
        for (const std::size_t k : right_)
            if (some = right_in(some, k); some.empty()) return std::nullopt;
        std::vector<std::size_t> put_right(some.size());
        for (const std::size_t k : wrong_) try_all(some, k, [&](std::size_t i, bool is) { put_right[i] += is; });
        const std::size_t best = std::size_t(std::ranges::max_element(put_right) - put_right.begin());
        const Effect further = some.empty() ? Effect{} : effect_on_further(some[best]);
        if (some.empty() || further.breaks) return std::nullopt;
        constexpr double nearly_all = 0.99;  // at most: some call stays wrong
        const double share =
            std::min(double(put_right[best] + further.put_right) / double(wrong_.size() + further.wrong), nearly_all);
        if (share < least_share) return std::nullopt;
        return Repair{fmt::format("{}, {:.0f} % of the wrong answers are right", in_words(all_, some[best]),
                                  std::floor(100 * share + 1e-9)),
                      line_of(all_, some[best]), share};
    }

    /// What a textbook has in the place of each expression.
    std::vector<Mistake> with_borrowed() {
        // a function's own words are those of its arguments: the last place is rather in it than in a helper above it
        constexpr double least_cost = 1.3, of_letter = 0.01, of_place = -1e-6;
        if (!arguments_vary_) borrowed_ = Borrowed(calls_);
        std::set<int> compared;  // what is in a condition is nothing that is computed with
        for (const textbook::Node& node : source_.nodes)
            if (is_comparison(node)) compared.insert(node.parts.begin(), node.parts.end());
        std::vector<Mistake> all;
        std::size_t at = calls_.rows.front().size() + quantities_.size();
        for (const Borrowed::Expression& other : borrowed_.all()) {
            for (std::size_t i = 0; i < all_.seen.size(); ++i) {
                const bool is_vector = all_.seen[i] == textbook::Value::Kind::vector;
                if (other.is_vector ? !is_vector : all_.seen[i] != textbook::Value::Kind::number) continue;
                const double cost = least_cost + of_letter * double(other.words.size()) + of_place * double(i);
                Mistake one{"{1}", "", cost, {}, other.words};
                one.made.nodes = {int(i)}, one.made.other_at = at;
                one.made.made = is_vector ? textbook::Made::vector_with : textbook::Made::number_with;
                if (source_.nodes[i].function.empty() && (other.is_compared || !compared.contains(int(i))))
                    all.push_back(std::move(one));
            }
            at += other.is_vector ? 3 : 1;
        }
        return all;
    }

    /// Pairs of simple ones at different places.
    std::vector<Edit> two(const std::vector<Mistake>& changes) const {
        constexpr std::size_t most = 400;
        std::vector<Edit> simple, pairs;
        for (const Mistake& change : changes)
            if (change.cost <= dearest_of_two && simple.size() < most) simple.push_back({&change});
        for (std::size_t b = 1; b < simple.size(); ++b)
            for (std::size_t a = 0; a < b; ++a)
                if (!all_.overlap(simple[a].first->made, simple[b].first->made))
                    pairs.push_back({simple[a].first, simple[b].first});
        return pairs;
    }

    std::optional<Calls> further_;
};

}  // namespace

std::optional<Repair> repair_of(const Calls& calls, const Editable& source, bool only_one) {
    return calls.size() == 0 ? std::nullopt : Repairs(calls, source).run(only_one);
}

}  // namespace grade
