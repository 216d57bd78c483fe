#include "diagnosis/search.h"

#include <fmt/format.h>

#include <algorithm>

namespace grade {

namespace {

constexpr std::size_t most_pairs = 36;  // changes that are tried by twos

}  // namespace

void Search::one_of_several() {
    constexpr double share_of_wrong = 0.5, share_of_changed = 0.8;
    constexpr std::size_t least = 8;
    constexpr double dearest = 2;
    if (calls_.result.parts.front().kind == Kind::flag) return;  // true and false agree by chance
    std::size_t most = 0;
    for (const Change& change : changes_) {
        if (change.cost > dearest) break;
        const auto right = answers(change, nullptr, all_);
        if (!right || !tells(*right, all_)) continue;
        std::size_t changed = 0, same = 0, telling = 0;
        Rows others;
        for (const std::size_t k : all_) {
            const bool equal = is_equal(calls_.result, (*right)[k], calls_.mine[k]);
            if (!equal && std::ranges::count(wrong_, k) > 0) others.push_back(calls_.rows[k]);
            if (is_equal(calls_.result, (*right)[k], calls_.right[k])) continue;
            ++changed, same += equal;
            // nothing, or something, may be right for many reasons
            telling += equal && is_something(calls_.mine[k]) && is_something(calls_.right[k]);
        }
        const bool explains = double(same) >= share_of_wrong * double(wrong_.size()) &&
                              double(same) >= share_of_changed * double(changed);
        if (!explains || telling < least || same <= most) continue;
        most = same;
        const bool are_all = same == wrong_.size();
        best_ = Relation{change.words, Relation::Kind::change};
        best_->calls = are_all ? fmt::format("in all {} wrong calls ", same)
                               : fmt::format("in {} of {} wrong calls ", same, wrong_.size());
        best_->everywhere = false, best_->cost = best_cost, best_->explains = Relation::Explains::some;
        best_->share = double(same) / double(wrong_.size());
        best_->others_remain = !are_all, best_->others = std::move(others);
    }
}

bool Search::is_same_in(const Change& first, const Change& second, const std::vector<std::size_t>& scope) const {
    const auto some = answers_in(first, &second, scope);
    for (std::size_t i = 0; some && i < scope.size(); ++i)
        if (!is_equal(calls_.result, calls_.mine[scope[i]], (*some)[i])) return false;
    return some.has_value();
}

bool Search::are_of_one(const Change& first, const Change& second) {
    return !first.replaced.empty() && first.replaced == second.replaced;
}

void Search::two_changes(const std::vector<std::size_t>& scope) {
    // sifted: which part of the calls tells them apart
    std::vector<std::size_t> sample;
    for (const std::size_t k : wrong_)
        if (sample.size() < few) sample.push_back(k);
    std::vector<const Change*> list;
    for (const Change& change : changes_) {
        if (list.size() >= most_pairs) break;
        if (change.cost > 1.5) break;
        const auto right = answers(change, nullptr, sample);
        if (right && std::ranges::any_of(
                         sample, [&](std::size_t k) { return !is_equal(calls_.result, (*right)[k], calls_.right[k]); }))
            list.push_back(&change);
    }
    for (std::size_t a = 0; a < list.size(); ++a)
        for (std::size_t b = 0; b < list.size(); ++b) {
            const double cost = list[a]->cost + list[b]->cost + 1;
            if (a == b || (best_ && cost >= best_->cost) || are_of_one(*list[a], *list[b])) continue;
            if (!is_same_in(*list[a], *list[b], sample)) continue;
            const auto right = answers(*list[a], list[b], scope);
            if (right && tells(*right, scope))
                consider(*right, list[a]->words + ", and " + list[b]->words, cost, scope, true);
        }
}

std::optional<Relation> Search::which_parts() const {
    // where a direction is right, the random numbers are used as the solution does, and what is wrong is wrong; the
    // other way round, another direction may be as good
    if (parts_.size() == calls_.result.parts.size() ||
        std::ranges::any_of(parts_, [&](const Field* part) { return is_place(*part); }))
        return std::nullopt;
    std::string good, words;
    for (const Field& part : calls_.result.parts)
        if (std::ranges::count(parts_, &part) == 0) good += (good.empty() ? "" : ", ") + name_of(part);
    for (const Field* part : parts_) words += (words.empty() ? "" : ", ") + name_of(*part);
    Relation told{fmt::format("{} {} right, {} {} not", good,
                              calls_.result.parts.size() - parts_.size() > 1 ? "are" : "is", words,
                              parts_.size() > 1 ? "are" : "is")};
    told.cost = best_cost, told.explains = Relation::Explains::nothing, told.share = 0;
    return told;
}

}  // namespace grade
