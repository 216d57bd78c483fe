#include "diagnosis/how.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/forms/by_textbook.h"
#include "diagnosis/rules/rule.h"
#include "diagnosis/rules/shares.h"
#include "diagnosis/samples/own_numbers.h"
#include "diagnosis/samples/spread.h"
#include "diagnosis/surest.h"

namespace grade {

namespace {

/// What explains the answers to these calls, all of which count.
std::optional<Relation> relation_in(const Calls& calls, const Ask& right, bool sampled, std::size_t& left_of_forms) {
    const auto of_arguments = relation_of(calls, right, sampled);
    if (is_no_mistake(of_arguments)) return std::nullopt;
    const auto of_form = relation_of_textbook(calls, sampled, left_of_forms);
    return is_no_mistake(of_form) ? std::nullopt : simpler(of_arguments, of_form);
}

}  // namespace

How how_of(const Relation& relation) {
    return {relation.all_words(), relation.is_change() || relation.by_repair ? relation.all_words() : ""};
}

How of_own_numbers(const Calls& all, const Ask& mine, const Ask& right) {
    const auto own = with_own_numbers(all, right);
    if (!own) return {};
    std::size_t left = most_of_textbook;
    if (!own->wrong().empty()) {
        const auto found = relation_in(*own, right, false, left);
        return is_exact(found) ? How{found->all_words(), how_of(*found).of_numbers, true} : How{};
    }
    const auto place = std::ranges::find_if(own->result.parts, is_place),
               measure = std::ranges::find_if_not(own->result.parts, is_place);
    const auto spread = spread_of(all, all, mine, right);
    if (!spread || measure == own->result.parts.end()) return {};
    return {fmt::format("each `{}` is right for its `{}`, but these are not spread so: {}", measure->name, place->name,
                        *spread)};
}

std::string wrong_sums(const Calls& all, const Ask& mine, const Ask& right) {
    const std::string rule = wrong_rule(all, mine, right);
    return rule.empty() ? wrong_shares(all, mine, right) : rule;
}

How of_numbers(const Calls& calls, const Ask& right, bool sampled) {
    const Calls some = those_of(calls, [&](std::size_t k) { return !is_nan(calls.mine[k], calls.right[k]); });
    const std::string words = "some answers are nan where the right one is a number";
    if (some.wrong().size() < enough_wrong) return {words};
    std::size_t left = most_of_textbook;
    auto found = relation_in(some, right, sampled, left);
    if (!is_exact(found)) found = two_of_textbook(some, left);
    if (!is_exact(found)) return {words};
    const std::string there = "where it is a number, " + found->all_words();
    return {words + "; " + there, there};
}

}  // namespace grade
