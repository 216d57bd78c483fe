#include "diagnosis/repair.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "diagnosis/calls_made.h"
#include "diagnosis/edits_in_words.h"
#include "diagnosis/integrals.h"
#include "diagnosis/quantities.h"
#include "diagnosis/renamed.h"

namespace grade {

namespace {

using textbook::Value;

constexpr std::size_t most_of_each = 48;                     // calls
constexpr std::size_t most_at_once = 2'000;                  // rows in one frame
constexpr std::size_t most_rows = 400'000;                   // in all
constexpr std::size_t most_rows_of_spread = most_rows / 2;   // after repair_of, which has asked as well
constexpr double least_share = 0.5;                          // of the wrong calls
constexpr double dearest_alone = 1.5, dearest_of_two = 1.3;  // of one that puts most right; of each of two

/// Lengths as they are written in a source, and their squares.
std::vector<Quantity> as_code(std::vector<Quantity> all) {
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        if (all[i].kind != Quantity::Kind::length || all[i].vector.empty()) continue;
        Quantity square = all[i];
        square.words = fmt::format("dot({0}, {0})", all[i].vector), square.kind = Quantity::Kind::product;
        square.value = [length = all[i].value](const Row& row, const Layout& layout, const Row& output) {
            return std::pow(length(row, layout, output), 2);
        };
        all[i].words = fmt::format("length({})", all[i].vector);
        all.push_back(std::move(square));
    }
    return all;
}

class Repairs {
public:
    Repairs(const Calls& calls, const Editable& source) : calls_(calls), source_(source) {
        for (std::size_t k = 0; k < calls.size(); ++k) (is_right(k, calls.mine[k]) ? right_ : wrong_).push_back(k);
        wrong_ = spread(wrong_), right_ = spread(right_);
        for (std::size_t k = 0; k < calls.size(); ++k)
            if (std::ranges::count(wrong_, k) + std::ranges::count(right_, k) == 0) others_.push_back(k);
    }

    std::optional<Repair> run(bool only_one) {
        if (wrong_.size() < enough_wrong || !see()) return std::nullopt;
        const std::vector<Mistake> changes = mistakes_in(all_, arguments_, told_);
        std::vector<Edit> one;
        for (const Mistake& change : changes) one.push_back({&change});
        if (auto repair = of_all(one)) return repair;
        if (auto repair = of_all(renamed(all_, changes)); repair || only_one) return repair;
        if (auto repair = of_all(two(changes))) return repair;
        return of_most(one);
    }

    /// See repair_of_spread.
    std::optional<Repair> of_spread(const Ask& right) {
        const Calls wrong = only_wrong(calls_);
        // 36 samples of one call turn nearly all changes away, within four times what so few leave to chance; what
        // passes must hold in nine calls of 2,304 samples, which leave less than half a percent: a number of arguments
        // whose rows take turns, lest all be of one kind
        const auto rough = Integrals::of(wrong, right, 1, 6, 0.3), closer = Integrals::of(wrong, right, 2, 12, 0.1),
                   fine = Integrals::of(wrong, right, 9, 48, 0.02);
        const auto among_all = Integrals::of(calls_, right, 9, 48, 0.02);  // right calls must stay so
        if (!rough || !closer || !fine || !among_all || !see() || are_right({}, *fine)) return std::nullopt;
        std::vector<Mistake> changes = mistakes_in(all_, arguments_, told_);  // the simplest first
        // integrals of an odd one may be right by chance: none that is less simple than `max(x, 0)`, but for another
        // value in the place of one
        constexpr double dearest = 1.35;
        std::erase_if(changes, [&](const Mistake& m) {
            const bool is_literal = std::isdigit(static_cast<unsigned char>(all_.node(m.made.nodes.front()).text[0]));
            return m.cost > dearest && (m.pattern != "{1}" || is_literal);
        });
        const std::size_t at_once = most_at_once / rough->rows().size() + 1;
        for (std::size_t from = 0; from < changes.size() && asked_ < most_rows_of_spread; from += at_once) {
            std::vector<Edit> edits;
            for (std::size_t i = from; i < std::min(changes.size(), from + at_once); ++i)
                edits.push_back({&changes[i]});
            const std::vector<Rows> all = answers(edits, rough->rows());
            for (std::size_t i = 0; i < all.size(); ++i)
                if (rough->are_right(all[i]) && are_right(edits[i], *closer) && are_right(edits[i], *fine) &&
                    are_right(edits[i], *among_all))
                    return Repair{.words = in_words(all_, edits[i]) + ", the samples are spread as they must be",
                                  .line = line_of(all_, edits[i]),
                                  .cost = edits[i].cost()};
        }
        return std::nullopt;
    }

private:
    bool are_right(const Edit& edit, const Integrals& integrals) {
        const std::vector<Rows> all = answers({edit}, integrals.rows());
        return !all.empty() && integrals.are_right(all[0]);
    }

    /// Of each edit, to all of these calls; empty: the program has ended.
    std::vector<Rows> answers(const std::vector<Edit>& edits, const Rows& calls) {
        Rows rows;
        for (const Edit& edit : edits)
            for (const Row& row : calls) {
                textbook::EditedCall one{source_.nodes.size(), false, {}, row};
                for (const Quantity& quantity : quantities_)
                    one.more.push_back(quantity.value(row, calls_.layouts.front(), {}));
                rows.push_back(textbook::row_of(one, edit.first ? &edit.first->made : nullptr, nullptr));
            }
        asked_ += rows.size();
        const Rows all = source_.ask(rows);
        std::vector<Rows> of_each;
        if (all.size() != rows.size()) return of_each;
        for (std::size_t i = 0; i < edits.size(); ++i) {
            const auto first = all.begin() + std::ptrdiff_t(i * calls.size());
            of_each.emplace_back(first, first + std::ptrdiff_t(calls.size()));
        }
        return of_each;
    }

    static std::vector<std::size_t> spread(const std::vector<std::size_t>& all) {
        std::vector<std::size_t> some;
        const std::size_t count = std::min(all.size(), most_of_each);
        for (std::size_t i = 0; i < count; ++i) some.push_back(all[i * all.size() / count]);
        return some;
    }

    bool is_right(std::size_t k, const Row& answer) const { return is_answer(calls_.result, answer, calls_.right[k]); }

    /// Whether it is the student's fragment, as long as nothing is changed.
    bool answers_as_before(const Rows& answers) const {
        std::size_t i = 0;
        for (const auto* some : {&wrong_, &right_})
            for (const std::size_t k : *some) {
                if (i >= answers.size() || answers[i].size() != calls_.mine[k].size()) return false;
                if (!is_equal(calls_.result, answers[i++], calls_.mine[k])) return false;
            }
        return true;
    }

    /// What the expressions' values are, and which of the arguments' dot products and lengths may be missing in them;
    /// false: the program does not tell.
    bool see() {
        arguments_ = calls_.layouts.front(), told_ = calls_.told;
        bool any_varies = false;
        for (std::size_t i = 0; i < arguments_.parts.size(); ++i) {
            const std::string& name = arguments_.parts[i].name;
            const bool varies = source_.varying.contains(name.substr(0, name.find('.')));
            any_varies = any_varies || varies;
            if (varies) told_[i] = false;
        }
        if (!any_varies) quantities_ = as_code(quantities_of(arguments_, told_));
        for (std::size_t i = 0; i < quantities_.size(); ++i) {
            arguments_.parts.push_back({quantities_[i].words, Kind::number, calls_.rows.front().size() + i});
            told_.push_back(quantities_[i].kind != Quantity::Kind::number);
        }
        all_.nodes = source_.nodes;
        all_.seen.assign(source_.nodes.size(), Value::Kind::none);
        Rows rows, as_it_is;
        for (const auto* some : {&wrong_, &right_})
            for (const std::size_t k : *some) {
                rows.push_back(textbook::row_of(call(k, true)));
                as_it_is.push_back(textbook::row_of(call(k, false)));
            }
        if (!answers_as_before(source_.ask(as_it_is))) return false;
        const Rows kinds = source_.ask(rows);
        for (const Row& row : kinds)
            for (std::size_t i = 0; i < std::min(row.size(), all_.seen.size()); ++i)
                if (row[i] > 0 && row[i] < double(Value::Kind::vector) + 1) all_.seen[i] = Value::Kind(int(row[i]));
        return kinds.size() == rows.size();
    }

    textbook::EditedCall call(std::size_t k, bool only_kinds) const {
        textbook::EditedCall all{source_.nodes.size(), only_kinds, {}, calls_.rows[k]};
        // lists may be longer in other calls: then the quantities stand elsewhere
        if (all.arguments.size() == calls_.rows.front().size())
            for (const Quantity& quantity : quantities_)
                all.more.push_back(quantity.value(calls_.rows[k], calls_.layouts[k], {}));
        return all;
    }

    /// visit(i, whether the call is right with edits[i]); false: no more may be asked.
    template <class Visit>
    bool try_all(const std::vector<Edit>& edits, std::size_t k, Visit visit) {
        const textbook::EditedCall as_it_is = call(k, false);
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
        const Edit& best = *std::ranges::min_element(edits, {}, &Edit::cost);
        constexpr double simple = 1.6;
        return Repair{in_words(all_, best) + or_elsewhere(edits, best) + ", every answer is right",
                      line_of(all_, best),
                      1,
                      best.cost() <= simple,
                      best.second != nullptr && !best.in_one_expression,
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
        constexpr double nearly_all = 0.99;  // at most: some call stays wrong
        const double share = some.empty() ? 0 : std::min(double(put_right[best]) / double(wrong_.size()), nearly_all);
        if (share < least_share) return std::nullopt;
        return Repair{fmt::format("{}, {:.0f} % of the wrong answers are right", in_words(all_, some[best]),
                                  std::floor(100 * share + 1e-9)),
                      line_of(all_, some[best]), share};
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

    const Calls& calls_;
    const Editable& source_;
    std::vector<std::size_t> wrong_, right_, others_;  // calls: some of either kind, and the rest of both
    Layout arguments_;                                 // and the quantities behind them
    std::vector<bool> told_;
    std::vector<Quantity> quantities_;
    Expressions all_;
    std::size_t asked_ = 0;
};

}  // namespace

std::optional<Repair> repair_of(const Calls& calls, const Editable& source, bool only_one) {
    return calls.size() == 0 ? std::nullopt : Repairs(calls, source).run(only_one);
}

std::optional<Repair> repair_of_spread(const Calls& calls, const Editable& source, const Ask& right) {
    return calls.size() == 0 ? std::nullopt : Repairs(calls, source).of_spread(right);
}

}  // namespace grade
