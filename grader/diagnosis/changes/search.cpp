#include "diagnosis/changes/search.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/changes/answer_forms.h"

namespace grade {

Search::Search(const Calls& calls, const Ask& right, bool sampled)
    : calls_(calls),
      ask_(right),
      sampled_(sampled),
      wrong_(calls.wrong()),
      parts_(calls.wrong_parts()),
      changes_(changes_of(calls.layouts.front(), calls.told)) {
    for (std::size_t k = 0; k < calls.size(); ++k) all_.push_back(k);
}

std::optional<Rows> Search::answers_in(const Change& first, const Change* second,
                                       const std::vector<std::size_t>& scope) const {
    Rows rows;
    for (const std::size_t k : scope) {
        Row row = calls_.rows[k];
        if (!first.make(row, calls_.layouts[k])) return std::nullopt;
        // a list may have become shorter
        const bool as_it_was = row.size() == calls_.rows[k].size();
        if (second && !second->make(row, as_it_was ? calls_.layouts[k] : calls_.signature.of_arguments(row)))
            return std::nullopt;
        rows.push_back(std::move(row));
    }
    Rows given = ask_(rows);
    if (given.size() != rows.size()) return std::nullopt;
    for (std::size_t i = 0; i < scope.size(); ++i)
        if (given[i].size() != calls_.mine[scope[i]].size()) return std::nullopt;
    return given;
}

std::optional<Rows> Search::answers(const Change& first, const Change* second,
                                    const std::vector<std::size_t>& scope) const {
    auto given = answers_in(first, second, scope);
    if (!given) return given;
    Rows all = calls_.right;
    for (std::size_t i = 0; i < scope.size(); ++i) all[scope[i]] = std::move((*given)[i]);
    return all;
}

bool Search::all_equal(const Rows& right, const std::vector<std::size_t>& scope) const {
    return std::ranges::all_of(scope, [&](std::size_t k) { return is_equal(calls_.result, calls_.mine[k], right[k]); });
}

void Search::consider(const Rows& right, const std::string& change, double cost, const std::vector<std::size_t>& scope,
                      bool only_simple, const std::string& usually) {
    std::string forms;
    AnswerForm::Kind last = AnswerForm::Kind::other;
    bool is_constant = false;
    for (const Field* part : parts_) {
        const auto form = form_of(calls_, *part, right, scope, only_simple);
        // a change and a constant together explain much by chance
        if (!form ||
            (!change.empty() && parts_.size() < 2 && !form->words.empty() && form->kind != AnswerForm::Kind::not_unit))
            return;
        cost += form->cost;
        if (form->words.empty()) continue;
        forms += fmt::format("{}{} {}", forms.empty() ? "" : ", and ", name_of(*part), form->words);
        last = form->kind, is_constant = is_constant || form->kind == AnswerForm::Kind::constant;
    }
    // what is right must stay so
    for (const Field& part : calls_.result.parts)
        if (std::ranges::count(parts_, &part) == 0 && !std::ranges::all_of(scope, [&](std::size_t k) {
                return !counts(calls_.result, part, calls_.mine[k], right[k]) ||
                       is_equal(part, calls_.mine[k], right[k]);
            }))
            return;
    if (best_ && best_->cost <= cost) return;
    const bool everywhere = scope.size() == all_.size();
    const bool is_both = !change.empty() && !forms.empty();
    const char* const joint = !is_both ? "" : last == AnswerForm::Kind::not_unit ? ", and " : ", but ";
    best_ = Relation{change + joint + forms, change.empty() ? Relation::Kind::sentence : Relation::Kind::change};
    best_->calls = !region_.empty() || everywhere ? region_ : "in the wrong calls ";
    best_->usually = forms.empty() ? usually : "", best_->is_constant = is_constant;
    best_->everywhere = everywhere, best_->cost = cost;
}

bool Search::tells(const Rows& changed, const std::vector<std::size_t>& scope) const {
    constexpr double clearly = 10 * equal_within;
    std::size_t other = 0, left = 0;
    const Row* first = nullptr;
    bool varies = false;
    for (const std::size_t k : scope) {
        if (is_alike(calls_.result, changed[k], calls_.right[k], clearly)) {
            left += is_something(changed[k]);
            continue;
        }
        ++other;
        if (!first)
            first = &changed[k];
        else
            varies = varies || !is_equal(calls_.result, *first, changed[k]);
    }
    if (other < enough_wrong) return false;
    const bool is_number = std::ranges::none_of(*first, [](double x) { return std::isnan(x); });
    return varies || (is_number && other >= 2 * enough_wrong && left >= enough_wrong);
}

std::vector<std::size_t> Search::some_wrong(const std::vector<std::size_t>& scope) const {
    std::vector<std::size_t> wrong, sample;
    for (const std::size_t k : scope)
        if (calls_.is_wrong(k)) wrong.push_back(k);
    const std::size_t count = std::min(few, wrong.size());
    for (std::size_t i = 0; i < count; ++i) sample.push_back(wrong[i * wrong.size() / count]);
    return sample;
}

bool Search::may_be(const Rows& right, const std::vector<std::size_t>& sample) const {
    return sample.empty() || std::ranges::all_of(parts_, [&](const Field* part) {
               return form_of(calls_, *part, right, sample, true).has_value();
           });
}

void Search::one_change(const Change& base, const std::vector<std::size_t>& scope) {
    const auto sample = some_wrong(scope);
    const Change* first = nullptr;
    for (const Change& change : changes_) {
        const double cost = change.cost + base.cost;
        // of two that nothing tells apart, both are told where they are as simple as can be
        const bool is_other = first && cost == best_->cost && cost <= 1;
        if (best_ && cost >= best_->cost && !is_other) break;
        if (const auto some = answers(change, &base, sample); !some || !may_be(*some, sample)) continue;
        const auto right = answers(change, &base, scope);
        if (!right || !tells(*right, scope)) continue;
        if (is_other && all_equal(*right, scope)) {
            best_->said += ", or " + change.words;
            break;
        }
        consider(*right, change.words, cost, scope, true, change.usually);
        if (best_ && best_->cost == cost && all_equal(*right, scope)) first = &change;
    }
}

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
