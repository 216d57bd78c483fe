#include "diagnosis/forms/form_search.h"

#include <algorithm>
#include <cmath>

namespace grade {

namespace {

constexpr double least_of_some = 0.5, dearest_of_some = 1.3;  // share of the wrong calls; cost

}  // namespace

FormSearch::FormSearch(const Calls& calls, Asked& asked, std::size_t& left)
    : calls_(calls), asked_(asked), left_(left), wrong_(calls.wrong()) {
    const std::size_t count = std::min<std::size_t>(6, wrong_.size());
    for (std::size_t i = 0; i < count; ++i) {
        sample_.push_back(wrong_[i * wrong_.size() / count]);
        asked_.answer(calls.rows[sample_[i]], calls.layouts[sample_[i]]);
        computed_.emplace_back();
        for (const textbook::Value& value : textbook::watch.values)
            computed_.back().push_back(value.kind != textbook::Value::Kind::none);
    }
}

bool FormSearch::tells() const {
    return calls_.result.parts.front().kind == Kind::flag || std::ranges::any_of(calls_.mine, is_something);
}

bool FormSearch::has_right_part() const {
    return std::ranges::any_of(calls_.result.parts, [&](const Field& part) {
        const auto right = std::ranges::count_if(
            sample_, [&](std::size_t k) { return is_equal(part, calls_.mine[k], calls_.right[k]); });
        return 2 * std::size_t(right) > sample_.size();
    });
}

std::optional<Relation> FormSearch::one(bool or_of_arguments, double dearest) {
    std::optional<Relation> most;
    const std::vector<Change> changes =
        or_of_arguments ? changes_of(calls_.layouts.front(), calls_.told) : std::vector<Change>();
    const std::vector<Mistake> all = mistakes_and(changes);
    for (std::size_t i = 0; i < all.size() && all[i].cost <= dearest; ++i) {
        const Mistake& mistake = all[i];
        if (!may_explain(mistake)) continue;
        const double share = share_of(mistake);
        if (share == 1) return or_another(relation(mistake, 1), std::span(all).subspan(i));
        const bool is_condition = mistake.made.made == textbook::Made::yes || mistake.made.made == textbook::Made::no;
        if (is_condition) continue;  // a constant one explains some calls by chance
        if (share >= least_of_some && mistake.cost <= dearest_of_some && (!most || most->share < share))
            most = relation(mistake, share);
    }
    return most;
}

bool FormSearch::are_hits_alone() const {
    constexpr std::size_t enough = 48;
    return wrong_.size() < enough && std::ranges::all_of(wrong_, [&](std::size_t k) {
               return std::isinf(calls_.mine[k].front()) || std::isinf(calls_.right[k].front());
           });
}

std::optional<Relation> FormSearch::two() {
    if (are_hits_alone()) return std::nullopt;
    const std::vector<Change> changes = changes_of(calls_.layouts.front(), calls_.told);
    std::vector<Mistake> all = mistakes_and(changes);
    std::erase_if(all, [&](const Mistake& m) { return m.cost > dearest_of_pairs || !changes_an_answer(m); });
    for (std::size_t b = 1; b < all.size(); ++b)
        for (std::size_t a = 0; a < b; ++a) {
            if (are_in_one_place(all[a], all[b])) continue;
            if (left_ == 0) return std::nullopt;
            if (!explain_all(all[a], all[b])) continue;
            Relation both{asked_.words_of(all[a]) + ", and " + asked_.words_of(all[b]), Relation::Kind::change};
            both.of_two = true;
            both.cost = all[a].cost + all[b].cost, both.by_textbook = true;
            return both;
        }
    return std::nullopt;
}

std::vector<Mistake> FormSearch::mistakes_and(const std::vector<Change>& changes) {
    std::vector<Mistake> all = asked_.mistakes_of(calls_);
    const auto count = std::ptrdiff_t(all.size());
    for (const Change& change : changes) all.push_back({"", "", change.cost, {}, "", &change});
    std::ranges::inplace_merge(all, all.begin() + count, {}, &Mistake::cost);  // both are in order
    return all;
}

Relation FormSearch::or_another(Relation found, std::span<const Mistake> mistakes) {
    const auto is_alternative = [](const Mistake& m) { return m.made.alternative != 0; };
    const Mistake& first = mistakes.front();
    for (const Mistake& other : mistakes.subspan(1)) {
        if (!is_alternative(first) || other.cost > first.cost) break;
        if (!is_alternative(other) || are_in_one_place(first, other) || !may_explain(other) || share_of(other) < 1)
            continue;
        found.said += ", or " + asked_.words_of(other);
        break;
    }
    return found;
}

bool FormSearch::are_in_one_place(const Mistake& a, const Mistake& b) const {
    if (a.of_arguments || b.of_arguments) return a.of_arguments && b.of_arguments;
    return Expressions{asked_.form().nodes, asked_.first()}.overlap(a.made, b.made);
}

bool FormSearch::explains(std::size_t k, const Mistake& first, const Mistake* second) {
    constexpr std::size_t usual = 64;  // values that are computed for an answer
    const Row answer = asked_.answer(calls_.rows[k], calls_.layouts[k], &first, second);
    left_ -= std::min(left_, 1 + textbook::watch.passed / usual);
    return is_answer(calls_.result, answer, calls_.mine[k]);
}

bool FormSearch::may_explain(const Mistake& mistake) {
    int tried = 0;
    for (std::size_t i = 0; i < sample_.size() && tried < 2; ++i) {
        if (!mistake.of_arguments && !is_computed(i, mistake)) continue;
        ++tried;
        if (left_ == 0) return false;
        if (explains(sample_[i], mistake)) return true;
    }
    return false;
}

bool FormSearch::is_computed(std::size_t i, const Mistake& mistake) const {
    return std::ranges::any_of(mistake.made.nodes,
                               [&](int node) { return computed_[i][std::size_t(node - asked_.first())]; });
}

bool FormSearch::changes_an_answer(const Mistake& mistake) {
    return std::ranges::any_of(sample_, [&](std::size_t k) {
        return !is_answer(calls_.result, asked_.answer(calls_.rows[k], calls_.layouts[k], &mistake), calls_.right[k]);
    });
}

double FormSearch::share_of(const Mistake& mistake) {
    std::size_t equal = 0, something = 0;
    for (std::size_t k = 0; k < calls_.size(); ++k) {
        const bool is_explained = explains(k, mistake);
        const bool is_wrong = std::ranges::binary_search(wrong_, k);
        if (!is_explained && !is_wrong) return 0;
        equal += is_explained && is_wrong;
        something +=
            is_explained && is_wrong && is_something(calls_.mine[k]) && !is_void(calls_.result, calls_.mine[k]);
    }
    if (equal < wrong_.size() && 2 * something < equal + enough_wrong) return 0;  // nothing is right for many reasons
    return double(equal) / double(wrong_.size());
}

bool FormSearch::explain_all(const Mistake& first, const Mistake& second) {
    for (const std::size_t k : sample_)
        if (!explains(k, first, &second)) return false;
    for (std::size_t k = 0; k < calls_.size(); ++k)
        if (!explains(k, first, &second)) return false;
    return true;
}

Relation FormSearch::relation(const Mistake& mistake, double share) const {
    Relation found{asked_.words_of(mistake), Relation::Kind::change};
    found.edit = asked_.words_of(mistake, false), found.usually = mistake.usually;
    found.cost = mistake.cost, found.by_textbook = share == 1, found.share = share;
    if (share < 1) {
        found.calls = "in most wrong calls ", found.explains = Relation::Explains::some;
        found.others_remain = true;
    }
    return found;
}

}  // namespace grade
