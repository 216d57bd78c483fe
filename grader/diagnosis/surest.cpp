#include "diagnosis/surest.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/changes/answer_forms.h"
#include "diagnosis/forms/by_textbook.h"

namespace grade {

namespace {

/// A relation of the arguments, or of a form's expressions; of both, where nothing tells them apart.
std::optional<Relation> simpler_one(std::optional<Relation> of_arguments, std::optional<Relation> of_form) {
    if (!of_form) return of_arguments;
    if (!of_arguments) return of_form;
    if (of_form->explains != Relation::Explains::all)
        return of_arguments->explains == Relation::Explains::all || of_arguments->share >= of_form->share ? of_arguments
                                                                                                          : of_form;
    if (of_arguments->explains != Relation::Explains::all) return of_form;
    if (of_form->other_numbers) return of_arguments;
    // a name says more than how answers are made
    const bool has_name = of_form->kind == Relation::Kind::named_mistake;
    if (has_name && !of_arguments->has_change() && !of_arguments->is_constant) return of_form;
    constexpr double clearly = 0.25, as_cheap = 0.5;
    const bool is_change = of_form->has_change(), everywhere = of_form->everywhere;
    if (is_change && everywhere && (!of_arguments->everywhere || of_arguments->is_constant)) return of_form;
    if (is_change && of_form->cost < of_arguments->cost - clearly) return of_form;
    if (is_change && !of_arguments->has_change() && !everywhere && of_form->cost <= of_arguments->cost) return of_form;
    if (!of_form->is_change() || !of_arguments->is_change() || of_form->cost > of_arguments->cost + as_cheap)
        return of_arguments;
    if (has_name) return of_form;
    if (of_form->edit == of_arguments->said && of_form->said != of_form->edit) {
        of_form->usually = of_arguments->usually;
        return of_form;
    }
    if (of_form->cost < of_arguments->cost) std::swap(of_form, of_arguments);
    of_arguments->said += ", or " + of_form->said;
    return of_arguments;
}

}  // namespace

std::optional<Relation> simpler(const std::optional<Relation>& of_arguments, const std::optional<Relation>& of_form) {
    auto one = simpler_one(of_arguments, of_form);
    if (one) one->by_arguments = is_exact(of_arguments), one->by_textbook = is_exact(of_form);
    return one;
}

namespace {

/// The relation that is found in some of the calls, and found again in others: what holds by chance is not.
/// left_of_forms: see relation_of_textbook.
std::optional<Relation> sure_relation(const Calls& calls, const Ask& ask_right, bool sampled,
                                      std::size_t& left_of_forms) {
    std::size_t left = most_calls, left_again = most_calls;
    const Ask right = limited(ask_right, left), again_right = limited(ask_right, left_again);
    const auto found = [&](bool others, const Ask& ask, std::size_t most = most_compared) {
        const Calls some = picked(calls, most, others);
        const auto of_arguments = relation_of(some, ask, sampled);
        if (is_no_mistake(of_arguments)) return of_arguments;
        constexpr double simple = 1;
        if (is_exact(of_arguments) && of_arguments->is_change() && of_arguments->cost <= simple) {
            const auto known = known_mistake(some, sampled);
            return known ? known : of_arguments;
        }
        const auto of_form = relation_of_textbook(some, sampled, left_of_forms);
        return is_no_mistake(of_form) ? of_form : simpler(of_arguments, of_form);
    };
    auto relation = found(false, right);
    if (!is_exact(relation)) return relation;
    const auto again = found(true, again_right);
    if (is_no_mistake(again)) return again;
    return again && again->words() != relation->words() ? found(false, again_right, 2 * most_compared) : relation;
}

/// Which tests turn hits away that no range does.
std::string tests_of(const std::string& fragment) {
    if (fragment == "hit_sphere")
        return "the discriminant: b * b - a * c with c = dot(f, f) - r^2, which must not be negative";
    if (fragment == "hit_triangle")
        return "u, v and u + v: their signs, and whether they are divided by the determinant";
    return "abs(dot(p, u)) <= dot(u, u) and the same along v, with p measured from the centre";
}

/// Where no hit is found by what the checks ask, by rays that start near the shape.
std::optional<Relation> relation_near_shapes(const Calls& calls, const Ask& ask_mine, const Ask& ask_right,
                                             std::size_t& left_of_forms) {
    const Calls near = near_shapes(calls, ask_mine, ask_right);
    if (near.size() == calls.size()) return std::nullopt;
    auto found = sure_relation(near, ask_right, false, left_of_forms);
    if (is_exact(found) && !found->is_constant) return found;
    if (std::ranges::any_of(near.mine, is_something)) return std::nullopt;
    Relation none{
        "no ray hits, not even one that starts at the shape and may hit anywhere along its line: what turns "
        "hits away is not the range but a test before it, of " +
        tests_of(calls.signature.fragment)};
    none.is_constant = true;
    return none;
}

/// What is wrong in the calls that a relation does not explain. Where it is told what the one in most calls usually is,
/// that is enough.
void add_others(Relation& relation, const Calls& calls, const Ask& ask_right, bool sampled,
                std::size_t& left_of_forms) {
    const bool are_nothing = relation.only_where_not_nothing;
    if (!are_nothing && !(relation.others_remain && relation.usually.empty())) return;
    const Calls rest = those_of(calls, [&](std::size_t k) {
        const Row& row = calls.rows[k];
        // steps of a formula stand behind
        const auto starts_so = [&](const Row& other) {
            return other.size() >= row.size() && std::equal(row.begin(), row.end(), other.begin());
        };
        if (are_nothing) return is_void(calls.result, calls.right[k]) || !is_something(calls.right[k]);
        return !calls.is_wrong(k) || std::ranges::any_of(relation.others, starts_so);
    });
    if (rest.size() == 0 || only_wrong(rest).size() == 0) return;
    const auto found = sure_relation(rest, ask_right, sampled, left_of_forms);
    relation.in_others = is_exact(found) ? found->all_words() : usual_wrong_answer(rest);
    relation.is_constant = relation.is_constant || (is_exact(found) && found->is_constant);
}

/// Of several parts of an answer, each by itself; perhaps of some alone.
std::optional<Relation> relation_of_parts(const Calls& calls, const Ask& ask_right, bool sampled,
                                          std::size_t& left_of_forms) {
    constexpr std::size_t enough = 10;  // wrong calls
    std::optional<Relation> all;
    std::size_t wrong = 0, explained = 0;
    bool are_changes = true, is_place_explained = false;
    for (const Field& part : calls.result.parts) {
        Calls alone = calls;
        for (std::size_t k = 0; k < calls.size(); ++k) {
            alone.mine[k] = calls.right[k];
            for (std::size_t c = 0; c < size_of(part.kind); ++c)
                alone.mine[k][part.at + c] = calls.mine[k][part.at + c];
        }
        const std::size_t count = only_wrong(alone).size();
        if (count == 0) continue;
        ++wrong;
        auto found = sure_relation(alone, ask_right, sampled, left_of_forms);
        if (count < enough || !is_exact(found) || found->other_numbers) continue;
        ++explained;
        are_changes = are_changes && found->is_change();
        is_place_explained = is_place_explained || is_place(part);
        if (found->is_change())
            found->said = fmt::format("{} is exactly as if the fragment had {}", name_of(part), found->said),
            found->kind = Relation::Kind::sentence;
        if (all) {
            found->said = all->words() + "; " + found->words(), found->calls.clear();
            found->kind = Relation::Kind::sentence, found->of_two = true;
            found->everywhere = found->everywhere && all->everywhere;
            found->is_constant = found->is_constant || all->is_constant;
            found->only_where_not_nothing = all->only_where_not_nothing;
        }
        all = std::move(found);
    }
    // of a sample whose place is wrong, any measure may be so
    if (explained < wrong && sampled && !are_changes && !is_place_explained) return std::nullopt;
    if (all && explained < wrong)
        all->explains = Relation::Explains::some, all->share = double(explained) / double(2 * wrong);
    return all;
}

}  // namespace

std::optional<Relation> surest_relation(const Calls& calls, const Ask& mine, const Ask& right, bool sampled) {
    std::size_t left_of_forms = most_of_textbook;
    auto best = sure_relation(calls, right, sampled, left_of_forms);
    if (is_no_mistake(best)) return best;
    const auto take = [&](std::optional<Relation> other) {
        if (is_exact(other)) best = std::move(other);
    };
    if (!is_exact(best) || best->is_constant) take(relation_near_shapes(calls, mine, right, left_of_forms));
    if (!is_exact(best) && calls.result.parts.size() > 1) {
        auto parts = relation_of_parts(calls, right, sampled, left_of_forms);
        if (parts && (is_exact(parts) || !best || best->share < parts->share)) best = std::move(parts);
    }
    std::size_t left_of_pairs = most_of_textbook;
    if (!is_exact(best)) take(two_of_textbook(picked(calls, most_compared), left_of_pairs));
    if (best) add_others(*best, calls, right, sampled, left_of_forms);
    return best;
}

bool tells_of_few(const Relation& relation, const Calls& all) {
    if (relation.explains != Relation::Explains::all || !relation.is_constant) return false;
    const std::vector<std::size_t> wrong = all.wrong();
    const auto nothing =
        std::size_t(std::ranges::count_if(wrong, [&](std::size_t k) { return is_void(all.result, all.mine[k]); }));
    return nothing > 0 && 2 * nothing < wrong.size();
}

}  // namespace grade
