#include "diagnosis/changes/search.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/where/where.h"

namespace grade {

std::string Relation::words() const {
    const bool of_change = kind == Kind::change || kind == Kind::named_mistake;
    return calls + (of_change ? "the fragment answers exactly as if it had " : "") + said +
           (!others_remain      ? ""
            : in_others.empty() ? "; in the others something else is wrong"
                                : "; in the others, " + in_others);
}

std::string Relation::all_words() const {
    std::string all = words() + usually;
    if (only_where_not_nothing && !in_others.empty()) all += "; elsewhere, " + in_others;
    if (!repair.empty()) return all + "; " + repair;
    return line == 0 ? all : fmt::format("{}{} line {}", all, all.ends_with('?') ? " See" : ": see", line);
}

Relation no_mistake() {
    Relation found;
    found.explains = Relation::Explains::no_mistake;
    return found;
}

std::optional<Relation> Search::run() {
    if (wrong_.size() < enough_wrong) return std::nullopt;
    const auto bases = same_sampling(calls_.layouts.front());
    for (const Change& base : bases)
        if (const auto right = sampled_ ? answers(base, nullptr, all_) : std::nullopt; right && all_equal(*right, all_))
            return no_mistake();
    for (const Change& base : bases) {
        if (!sampled_ && &base != &bases.front()) break;
        const auto right = answers(base, nullptr, all_);
        if (!right) continue;
        consider(*right, {}, base.cost, all_, false);
        one_change(base, all_);
        if (best_) best_->is_elsewhere = base.cost > 0;
        if (best_) return best_;
    }
    if (auto there = by_choice()) return there;
    const bool is_flag = calls_.result.parts.front().kind == Kind::flag;  // true and false agree by chance
    const bool some_right = wrong_.size() < all_.size() && !sampled_ && !is_flag;
    WrongCalls there;
    if (some_right) {
        consider(calls_.right, {}, 0, wrong_, false);
        // a change that would spoil right calls is no cause, unless it is known which calls it is made in
        there = where_wrong(calls_);
        if (there.is_exact) {
            region_ = there.words + ", ";
            one_change(bases.front(), wrong_);
            region_.clear();
        }
        if (best_) return best_;
    }
    if (!sampled_)
        if (auto there = where_it_is_not_nothing()) return there;
    one_of_several();
    if (best_) return best_;
    return which_parts();
}

std::optional<Relation> by_kinds(const Calls& calls,
                                 const std::function<std::optional<Relation>(const Calls&)>& of_some) {
    const auto& parts = calls.layouts.front().parts;
    // true and false agree by chance
    if (calls.result.parts.front().kind == Kind::flag) return std::nullopt;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if ((parts[i].kind != Kind::choice && parts[i].kind != Kind::flag) || !calls.told[i]) continue;
        std::vector<std::pair<Relation, std::string>> found;  // each with the kinds that it is of
        bool are_all = true;
        for (int value = 0; value < 5; ++value) {
            const Calls some =
                those_of(calls, [&](std::size_t k) { return calls.rows[k][calls.layouts[k].parts[i].at] == value; });
            if (some.size() == 0 || some.size() == calls.size() || only_wrong(some).size() == 0) continue;
            const auto one = of_some(some);
            are_all = are_all && one;
            if (!one) continue;
            const std::string kind = value_in_words({parts[i].name, parts[i].kind, 0}, {double(value)});
            const auto same =
                std::ranges::find_if(found, [&](const auto& f) { return f.first.words() == one->words(); });
            if (same != found.end())
                same->second += " or " + kind;
            else
                found.emplace_back(*one, kind);
        }
        if (found.empty()) continue;
        Relation all = found.front().first;
        std::string words;
        bool has_change = false;
        for (const auto& [one, kinds] : found) {
            has_change = has_change || one.has_change(), all.is_constant = all.is_constant || one.is_constant;
            words +=
                fmt::format("{}where `{}` is {}, {}", words.empty() ? "" : "; ", parts[i].name, kinds, one.words());
        }
        all.said = words + (are_all ? "" : "; other calls are wrong as well"), all.everywhere = false;
        all.kind = has_change ? Relation::Kind::of_kinds : Relation::Kind::sentence;
        return all;
    }
    return std::nullopt;
}

std::optional<Relation> Search::by_choice() const {
    return by_kinds(calls_, [&](const Calls& some) { return Search(some, ask_, sampled_).one_mistake(); });
}

std::optional<Relation> Search::one_mistake() {
    if (wrong_.size() < enough_wrong) return std::nullopt;
    for (const Change& base : same_sampling(calls_.layouts.front())) {
        if (!sampled_ && base.cost > 0) break;
        const auto right = answers(base, nullptr, all_);
        if (!right || all_equal(*right, all_)) continue;
        consider(*right, {}, base.cost, all_, false);
        one_change(base, all_);
        if (best_) return best_;
    }
    return best_;
}

std::optional<Relation> Search::where_it_is_not_nothing() {
    std::vector<std::size_t> some;
    for (const std::size_t k : all_)
        if (is_something(calls_.right[k]) && !is_void(calls_.result, calls_.right[k])) some.push_back(k);
    if (some.size() < 2 * enough_wrong || some.size() == all_.size()) return std::nullopt;
    region_ = "where the right answer is not 0 or inf, ";
    one_change(same_, some);
    region_.clear();
    if (best_) best_->only_where_not_nothing = true;
    return best_;
}

std::optional<Relation> relation_of(const Calls& calls, const Ask& right, bool sampled) {
    return Search(calls, right, sampled).run();
}

}  // namespace grade
