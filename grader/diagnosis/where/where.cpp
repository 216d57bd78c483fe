#include "diagnosis/where/where.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "diagnosis/where/features.h"
#include "rt/math.h"

namespace grade {

namespace {

/// Of arguments that are flags and choices alone, which are wrong: all of them.
std::string table_of(const Calls& calls) {
    const Layout& layout = calls.layouts.front();
    if (!layout.lists.empty() || !layout.formulas.empty()) return {};
    for (const Field& part : layout.parts)
        if (part.kind != Kind::flag && part.kind != Kind::choice) return {};
    std::set<std::string> all;
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (calls.is_wrong(k)) all.insert(arguments_in_words(calls.signature, calls.rows[k]));
    std::string words;
    for (const std::string& one : all) words += (words.empty() ? "" : "; ") + one;
    return words;
}

/// Among calls whose right answers are as those of all wrong ones: not 0, or not inf.
WrongCalls where_among_alike(const Calls& calls) {
    if (calls.result.parts.front().kind == Kind::flag) return {};
    for (const Field& part : calls.result.parts)
        for (const double other : {0.0, rt::inf}) {
            const auto is_alike = [part, other](const Row& right) {
                for (std::size_t c = 0; c < size_of(part.kind); ++c)
                    if (right[part.at + c] != other) return true;
                return false;
            };
            const bool are_all = std::ranges::all_of(calls.right, is_alike);
            const Calls some = those_of(calls, [&](std::size_t k) { return is_alike(calls.right[k]); });
            const Calls rest =
                those_of(calls, [&](std::size_t k) { return !is_alike(calls.right[k]) && calls.is_wrong(k); });
            if (are_all || some.size() == 0 || rest.size() > 0) continue;
            WrongCalls region = rule_of(some, true);
            if (!region.is_exact) continue;
            region.words += fmt::format(" and the right {} is not {}", part.name.empty() ? "answer" : part.name,
                                        number_in_words(other));
            region.holds = [is_alike, holds = region.holds](const Row& row, const Layout& layout, const Row& right) {
                return is_alike(right) && holds(row, layout, right);
            };
            return region;
        }
    return {};
}

}  // namespace

std::string wrong_answers(const Calls& calls) {
    const auto& parts = calls.layouts.front().parts;
    const auto of_kind = [&](Kind kind) { return std::ranges::find(parts, kind, &Field::kind); };
    const auto choice = of_kind(Kind::choice), flag = of_kind(Kind::flag);
    if (parts.size() != 2 || choice == parts.end() || flag == parts.end()) return {};
    if (calls.result.parts.front().kind != Kind::flag) return {};
    const auto answer = [&](const Rows& answers, double value) {
        bool if_set = false, if_not = false;
        for (std::size_t k = 0; k < calls.size(); ++k)
            if (calls.rows[k][choice->at] == value)
                (calls.rows[k][flag->at] != 0 ? if_set : if_not) = answers[k][0] != 0;
        if (if_set == if_not) return std::string(if_set ? "true" : "false");
        return fmt::format("`{}{}`", if_set ? "" : "!", flag->name);
    };
    std::map<std::pair<std::string, std::string>, std::string> all;
    std::set<double> values;
    for (const Row& row : calls.rows) values.insert(row[choice->at]);
    for (const double value : values) {
        const std::string mine = answer(calls.mine, value), right = answer(calls.right, value);
        if (mine == right) continue;
        std::string& names = all[{mine, right}];
        names += (names.empty() ? "" : " or ") + value_in_words({choice->name, choice->kind, 0}, {value});
    }
    std::string words;
    for (const auto& [answers, names] : all)
        words += fmt::format("{}where `{}` is {}, the answer is {}; it must be {}", words.empty() ? "" : "; ",
                             choice->name, names, answers.first, answers.second);
    return words;
}

namespace {

/// "where", of which calls: what holds in all wrong ones may hold in some right ones as well.
const char* how_far(const WrongCalls& region, const Calls& calls) {
    if (region.is_exact) return "where ";
    for (const std::size_t k : calls.wrong())
        if (!region.holds(calls.rows[k], calls.layouts[k], calls.right[k])) return "nearly all of them where ";
    return "all of them where ";
}

}  // namespace

WrongCalls where_wrong(const Calls& calls, bool of_answers) {
    WrongCalls region = rule_of(calls, of_answers);
    if (!region.is_exact && of_answers)
        if (WrongCalls among = where_among_alike(calls); among.is_exact) region = std::move(among);
    if (const std::string words = region.is_exact ? "" : table_of(calls); !words.empty())
        region = {words, [](const Row&, const Layout&, const Row&) { return true; }, true};
    if (region.is_of_axis) region.words += ": a cross product with that axis is 0 there";
    if (!region.words.empty()) region.words = how_far(region, calls) + region.words;
    return region;
}

}  // namespace grade
