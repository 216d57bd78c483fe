#include <algorithm>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/samples/integrals.h"
#include "diagnosis/source/edited_calls.h"

namespace grade {

namespace {

class RepairsOfSpread : private EditedCalls {
public:
    RepairsOfSpread(const Calls& calls, const Editable& source, const Ask& right)
        : EditedCalls(calls, source), levels_(levels(calls, right)) {}

    std::optional<Repair> run() {
        if (levels_.empty() || !see() || are_right({}, levels_[levels_.size() - 2])) return std::nullopt;
        std::vector<Mistake> changes = mistakes_in(all_, arguments_, told_);  // the simplest first
        // integrals of an odd one may be right by chance: none that is less simple than `max(x, 0)`, but for another
        // value in the place of one
        constexpr double dearest = 1.35;
        std::erase_if(changes,
                      [&](const Mistake& m) { return m.cost > dearest && (m.pattern != "{1}" || is_literal(m.made)); });
        const std::optional<Edit> best = simplest(changes);
        if (!best) return std::nullopt;
        return Repair{.words = in_words(all_, *best) + ", the samples are spread as they must be",
                      .line = line_of(all_, *best),
                      .cost = best->cost()};
    }

private:
    static constexpr std::size_t most_rows = EditedCalls::most_rows / 2;  // after repair_of, which has asked as well

    /// 36 samples of one call turn nearly all changes away, within four times what so few leave to chance; what passes
    /// must hold in nine calls of 2,304 samples, which leave less than half a percent: a number of arguments whose rows
    /// take turns, lest all be of one kind; and right calls must stay so. Empty: there are no such integrals.
    static std::vector<Integrals> levels(const Calls& calls, const Ask& right) {
        const Calls wrong = only_wrong(calls);
        struct Level {
            const Calls& calls;
            std::size_t bases, side;
            double close;
        };
        std::vector<Integrals> all;
        for (const Level& level : {Level{wrong, 1, 6, 0.3}, Level{wrong, 9, 6, 0.3}, Level{wrong, 9, 16, 0.08},
                                   Level{wrong, 9, 48, 0.02}, Level{calls, 9, 48, 0.02}}) {
            auto one = Integrals::of(level.calls, right, level.bases, level.side, level.close);
            if (!one) return {};
            all.push_back(std::move(*one));
        }
        return all;
    }

    /// Of those that cost the same, the one that moves the fewest samples: where each may lie is not wrong if densities
    /// alone are.
    std::optional<Edit> simplest(const std::vector<Mistake>& changes) {
        const Integrals& rough = levels_.front();
        const std::vector<Rows> as_it_is = answers(std::vector{Edit{}}, rough.rows());
        const std::size_t at_once = most_at_once / rough.rows().size() + 1;
        std::optional<Edit> best;
        std::size_t fewest = 0;
        for (std::size_t from = 0; from < changes.size() && !as_it_is.empty() && asked_ < most_rows; from += at_once) {
            std::vector<Edit> edits;
            for (std::size_t i = from; i < std::min(changes.size(), from + at_once); ++i)
                edits.push_back({&changes[i]});
            const std::vector<Rows> all = answers(edits, rough.rows());
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (best && edits[i].cost() > best->cost()) return best;
                if (all[i] == as_it_is.front() || !rough.are_right(all[i]) || !holds(edits[i])) continue;
                const std::size_t moved = moved_by(all[i], as_it_is.front());
                if (!best || moved < fewest) best = edits[i], fewest = moved;
            }
        }
        return best;
    }

    /// Samples that lie elsewhere.
    std::size_t moved_by(const Rows& answers, const Rows& before) const {
        std::size_t count = 0;
        for (std::size_t k = 0; k < answers.size(); ++k)
            count += std::ranges::any_of(calls_.result.parts, [&](const Field& part) {
                return is_place(part) && !is_equal(part, answers[k], before[k]);
            });
        return count;
    }

    bool are_right(const Edit& edit, const Integrals& integrals) {
        const std::vector<Rows> all = answers({edit}, integrals.rows());
        return !all.empty() && integrals.are_right(all[0]);
    }

    bool holds(const Edit& edit) {
        return !is_nan_in_calls(edit) && std::all_of(levels_.begin() + 1, levels_.end(),
                                                     [&](const Integrals& one) { return are_right(edit, one); });
    }

    /// What integrals never ask: the ends of random numbers.
    bool is_nan_in_calls(const Edit& edit) {
        const std::vector<Rows> all = answers({edit}, calls_.rows);
        std::size_t k = 0;
        return all.empty() ||
               std::ranges::any_of(all[0], [&](const Row& answer) { return is_nan(answer, calls_.right[k++]); });
    }

    std::vector<Integrals> levels_;  // the roughest first
};

}  // namespace

std::optional<Repair> repair_of_spread(const Calls& calls, const Editable& source, const Ask& right) {
    return calls.size() == 0 ? std::nullopt : RepairsOfSpread(calls, source, right).run();
}

}  // namespace grade
