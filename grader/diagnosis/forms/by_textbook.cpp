#include "diagnosis/forms/by_textbook.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/forms/asked.h"
#include "diagnosis/forms/form_search.h"

namespace grade {

namespace {

/// visit(calls, form) with each form that the calls can be compared with.
template <class Visit>
void each_form(const Calls& calls, bool sampled, Visit visit) {
    for (const textbook::Form& form : textbook::forms()) {
        if (form.fragment != calls.signature.fragment || !form.says.empty() || calls.size() == 0) continue;
        Asked asked(form);
        if (const auto all = as_form_has(calls, asked, sampled)) visit(*all, asked);
    }
}

/// Whether answers are right as the calls have it.
bool are_right(const Calls& answers, const Calls& calls) {
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (!is_answer(calls.result, answers.right[k], calls.right[k])) return false;
    return true;
}

/// Whether those parts of an answer are mine.
bool is_as(const Calls& calls, std::size_t k, const std::vector<const Field*>& parts, const Row& answer) {
    if (answer.size() != calls.mine[k].size()) return false;
    if (is_void(calls.result, answer) && is_void(calls.result, calls.mine[k])) return true;
    return std::ranges::all_of(parts, [&](const Field* part) { return is_equal(*part, answer, calls.mine[k]); });
}

/// Those parts that are wrong in some call, if one of them is a place; else all.
std::vector<const Field*> wrong_parts_of(const Calls& calls) {
    std::vector<const Field*> parts = calls.wrong_parts();
    // a density or a weight may be any function's by chance
    if (std::ranges::none_of(parts, [](const Field* part) { return is_place(*part); })) {
        parts.clear();
        for (const Field& part : calls.result.parts) parts.push_back(&part);
    }
    return parts;
}

/// What it costs that a form answers as the calls do in all that is wrong; none: it does not.
std::optional<double> cost_as(const textbook::Form& form, const Calls& calls, bool sampled,
                              const std::vector<const Field*>& wrong_parts) {
    Asked asked(form);
    for (const Change& base : same_sampling(calls.layouts.front())) {
        if (base.cost > 0 && !sampled) break;
        std::size_t wrong = 0, left_out = 0;
        const auto is_explained = [&](std::size_t k) {
            Row row = calls.rows[k];
            base.make(row, calls.layouts[k]);
            const Row answer = asked.answer(row, calls.layouts[k]);
            // one who divides by 0 in a form may have guarded against it; a form of many steps may take too long
            if (answer.empty() || is_nan(answer, calls.mine[k])) return ++left_out, true;
            wrong += calls.is_wrong(k);
            return is_as(calls, k, wrong_parts, answer);
        };
        std::size_t k = 0;
        while (k < calls.size() && is_explained(k)) ++k;
        if (k == calls.size() && wrong >= enough_wrong && left_out <= calls.size() / 10) return base.cost;
    }
    return std::nullopt;
}

Relation named(const textbook::Form& mistake, std::string says, double cost) {
    Relation found{std::move(says), Relation::Kind::named_mistake};
    found.cost = 1 + cost, found.by_textbook = true, found.has_other_order = mistake.has_other_order;
    return found;
}

/// A form that is right, with one that is wrong as a whole in the place of a fragment that it calls.
std::optional<Relation> known_mistake_in_part(const Calls& calls, bool sampled) {
    const auto wrong_parts = wrong_parts_of(calls);
    for (const textbook::Form& form : textbook::forms()) {
        if (form.fragment != calls.signature.fragment || !form.says.empty()) continue;
        for (const textbook::Form& other : textbook::forms()) {
            if (other.says.empty() || other.fragment == form.fragment || !form.calls.contains(other.fragment)) continue;
            const textbook::StandIn stand_in(other);
            if (const auto cost = cost_as(form, calls, sampled, wrong_parts))
                return named(other, fmt::format("in place of `{}` this: {}", other.fragment, other.says), *cost);
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<Relation> known_mistake(const Calls& calls, bool sampled) {
    const auto wrong_parts = wrong_parts_of(calls);
    for (const textbook::Form& form : textbook::forms())
        if (form.fragment == calls.signature.fragment && !form.says.empty())
            if (const auto cost = cost_as(form, calls, sampled, wrong_parts)) return named(form, form.says, *cost);
    return std::nullopt;
}

std::optional<Relation> relation_of_textbook(const Calls& calls, bool sampled, std::size_t& left) {
    if (calls.size() == 0) return std::nullopt;
    if (auto known = known_mistake(calls, sampled)) return known;
    std::optional<Relation> best, some;
    bool is_right = false;
    each_form(calls, sampled, [&](const Calls& own, Asked& asked) {
        for (const Change& base : same_sampling(own.layouts.front())) {
            if (base.cost > 0 && (!sampled || best)) break;
            const Calls all = base.cost > 0 ? with_numbers(own, base, asked) : own;
            FormSearch search(all, asked, left);
            const bool is_of_all = own.size() == calls.size();  // else what is left out may be wrong
            is_right = is_right || (sampled && is_of_all && search.wrong() == 0);
            if (search.wrong() < enough_wrong || is_right || !search.tells()) continue;
            if (base.cost > 0 && !search.has_right_part()) continue;
            auto found = search.one();
            if (!found) continue;
            found->cost += base.cost, found->other_numbers = base.cost > 0;
            if (sampled && is_of_all && !are_right(own, calls)) found->other_form = &asked.form();
            if (found->explains != Relation::Explains::all) {
                if (base.cost == 0 && (!some || some->share < found->share)) some = std::move(found);
            } else if (!best || best->cost > found->cost) {
                best = std::move(found);
            }
        }
    });
    if (is_right) return no_mistake();
    if (!best)
        best = by_kinds(calls, [&](const Calls& of_one_kind) {
            std::optional<Relation> found;
            each_form(of_one_kind, false, [&](const Calls& own, Asked& asked) {
                FormSearch search(own, asked, left);
                if (search.wrong() < enough_wrong || !search.tells()) return;
                auto one = search.one();
                if (is_exact(one) && (!found || found->cost > one->cost)) found = std::move(one);
            });
            return found;
        });
    if (!best) best = known_mistake_in_part(calls, sampled);
    return best ? best : some;
}

namespace {

/// A form that is wrong as a whole, with one more mistake in it.
std::optional<Relation> known_mistake_and_another(const Calls& calls, const textbook::Form& form, std::size_t& left) {
    Asked asked(form);
    const auto as_form = with_answers_of(asked, calls);
    if (!as_form) return std::nullopt;
    FormSearch search(*as_form, asked, left);
    if (search.wrong() < enough_wrong) return std::nullopt;
    auto found = search.one(true, FormSearch::dearest_of_pairs);
    if (!is_exact(found)) return std::nullopt;
    found->said = form.says + ", and " + found->said, found->kind = Relation::Kind::named_mistake;
    found->of_two = true;
    return found;
}

}  // namespace

std::optional<Relation> two_of_textbook(const Calls& calls, std::size_t& left) {
    std::optional<Relation> best;
    const auto forms = std::ranges::count(textbook::forms(), calls.signature.fragment, &textbook::Form::fragment);
    const std::size_t share = left / std::size_t(std::max<std::ptrdiff_t>(forms, 1));
    each_form(calls, false, [&](const Calls& own, Asked& asked) {
        if (best) return;
        std::size_t own_share = share;
        FormSearch search(own, asked, own_share);
        if (search.wrong() >= enough_wrong && search.tells()) best = search.two();
        left -= share - own_share;
    });
    for (const textbook::Form& form : textbook::forms()) {
        if (best || form.fragment != calls.signature.fragment || form.says.empty()) continue;
        best = known_mistake_and_another(calls, form, left);
    }
    return best;
}

}  // namespace grade
