#include <algorithm>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/source/repair.h"

namespace grade {

namespace {

/// Whether all wrong answers are one: whatever gives that one explains them.
bool are_one_answer(const Calls& calls) {
    const Calls wrong = only_wrong(calls);
    return std::ranges::all_of(wrong.mine,
                               [&](const Row& row) { return is_equal(calls.result, row, wrong.mine.front()); });
}

}  // namespace

void add_repair(std::optional<Relation>& relation, const Calls& calls, const std::optional<Editable>& source,
                const Unused& unused) {
    const bool is_cause = is_exact(relation) && !relation->is_constant;
    const auto repair = source ? repair_of(calls, *source, is_cause) : std::nullopt;
    if (!repair) return;
    const bool is_all = repair->share == 1, is_by_chance = is_exact(relation) && relation->has_change() &&
                                                           !relation->calls.empty() && are_one_answer(calls);
    constexpr double odd = 1.9;  // what nobody writes by mistake, as `b / a` for `a`
    const bool is_odd =
        is_exact(relation) && (relation->of_two || (relation->kind == Relation::Kind::change && relation->cost >= odd));
    const bool is_less_simple = is_odd && repair->is_simple;
    const bool says_less = is_exact(relation) && relation->is_constant && repair->is_simple;
    if (is_all && (is_by_chance || is_less_simple || says_less)) relation.reset();
    // of the one change after which every answer is right
    const int line = is_all && !repair->is_of_two ? repair->line : 0;
    if (is_exact(relation)) {
        relation->line_of_repair = line;
        if (!is_all && is_cause) return;
        if (repair->is_of_literal && !relation->is_change()) return;  // "cut off at 1": another number is no better
        relation->by_repair = is_all, relation->cost_of_repair = repair->cost;
        relation->is_borrowed = repair->is_borrowed;
        constexpr double simple = 1.9;  // a change of arguments that a student may have made
        const bool is_told = relation->by_textbook || relation->cost < simple;
        // The student's own words, but for a mistake that has a name, or that is clearly simpler in others; what a
        // textbook has may not stand in the file.
        const double clearly = relation->by_arguments ? 0.25 : 0.5;
        const bool is_own = line > 0 && (repair->is_borrowed || repair->cost <= relation->cost + clearly);
        if (relation->is_change() && relation->kind == Relation::Kind::change && is_own)
            relation->said = repair->words, relation->usually.clear(), relation->kind = Relation::Kind::sentence;
        else if (relation->is_change() && is_told)
            relation->line = repair->line;
        else
            relation->repair = repair->words;
    } else if (is_all || !relation || relation->explains == Relation::Explains::nothing ||
               relation->share < repair->share) {
        const bool is_enough = is_all && repair->is_simple && !repair->is_of_two;
        const std::string known = !unused.numbers.empty() ? unused.numbers : is_enough ? "" : unused.others;
        relation = Relation{known.empty() ? repair->words : known + "; " + repair->words};
        relation->line_of_repair = line, relation->cost_of_repair = repair->cost;
        relation->is_borrowed = repair->is_borrowed;
        relation->by_repair = is_all, relation->share = repair->share, relation->of_two = repair->is_of_two;
        relation->explains = is_all ? Relation::Explains::all : Relation::Explains::some;
    }
}

}  // namespace grade
