#include "diagnosis/search.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/answer_forms.h"
#include "diagnosis/families.h"

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

void Search::one_constant(const std::vector<std::size_t>& scope) {
    std::vector<std::size_t> wrong;
    for (const std::size_t k : scope)
        if (std::ranges::count(wrong_, k) > 0) wrong.push_back(k);
    for (const Change& base : sampled_ ? same_sampling(calls_.layouts.front()) : std::vector<Change>{same_}) {
        const auto calls = with_base(base);
        if (!calls) continue;
        for (const Change& change : changes_with_constants(*calls, ask_, wrong)) {
            const auto right = answers(base, &change, scope);
            if (right && tells(*right, scope)) consider(*right, change.words, change.cost + base.cost, scope, true);
        }
    }
}

std::optional<Calls> Search::with_base(const Change& base) const {
    constexpr double least = 0.2;
    Calls calls = calls_;
    if (base.cost == 0) return calls;
    const auto right = answers(base, nullptr, all_);
    if (!right) return std::nullopt;
    std::size_t same = 0;
    for (std::size_t k = 0; k < calls.size(); ++k) {
        same += is_equal(calls_.result, calls_.mine[k], (*right)[k]);
        base.make(calls.rows[k], calls.layouts[k]);
    }
    return double(same) >= least * double(calls.size()) ? std::optional(std::move(calls)) : std::nullopt;
}

}  // namespace grade
