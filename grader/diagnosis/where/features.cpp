#include "diagnosis/where/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "diagnosis/calls/directions.h"
#include "diagnosis/calls/quantities.h"
#include "diagnosis/calls/scalars.h"
#include "diagnosis/where/features_of_parts.h"

namespace grade {

namespace {

constexpr double share = 0.95;       // of either kind that a rule must tell rightly
constexpr std::size_t at_least = 4;  // calls of either kind

WrongCalls region(const Feature& one, bool is_exact) {
    return {one.words, one.test, is_exact, one.of_answers, one.not_unit, {one.number}, one.is_of_axis};
}

class Features {
public:
    explicit Features(const Calls& calls, bool of_answers = true) : calls_(calls) {
        std::vector<std::size_t> all;
        for (std::size_t k = 0; k < calls.size(); ++k) {
            wrong_.push_back(calls.is_wrong(k));
            all.push_back(k);
        }
        told_ = told_of(calls, all);
        directions_ = directions_of(calls, told_);
        for (Feature& one : features_of_parts(calls, wrong_, told_)) add(std::move(one));
        for (Feature& one : features_of_axes(directions_)) add(std::move(one));
        if (of_answers)
            for (Feature& one : features_of_answers(calls.result)) add(std::move(one));
        quantities();
    }

    WrongCalls rule() const {
        const auto bad = std::size_t(std::ranges::count(wrong_, true));
        if (bad < at_least || wrong_.size() - bad < at_least) return {};
        const Feature* best = nullptr;
        double most = 0;
        for (const Feature& one : list_)
            if (const double s = score_alone(one); s > most) most = s, best = &one;
        if (most == 1) return region(*best, true);
        const Feature *first = nullptr, *second = nullptr;
        double most_of_two = std::max(most, share);
        for (std::size_t a = 0; a < list_.size(); ++a)
            for (std::size_t b = a + 1; b < list_.size(); ++b) {
                std::vector<bool> both(wrong_.size());
                for (std::size_t k = 0; k < both.size(); ++k) both[k] = list_[a].holds[k] && list_[b].holds[k];
                if (const double s = score(both); s > most_of_two)
                    most_of_two = s, first = &list_[a], second = &list_[b];
            }
        if (most >= share && most_of_two < 1) return region(*best, false);
        if (!first) return {};
        return {first->words + " and " + second->words,
                [one = first->test, other = second->test](const Row& row, const Layout& layout, const Row& right) {
                    return one(row, layout, right) && other(row, layout, right);
                },
                most_of_two == 1,
                first->of_answers,
                "",
                {first->number, second->number}};
    }

private:
    /// The worse of both shares that are told rightly, of wrong calls and of those where the rule holds; 0 where it
    /// holds for right ones as well.
    double score(const std::vector<bool>& holds) const {
        double wrong = 0, holding = 0, both = 0;
        for (std::size_t k = 0; k < holds.size(); ++k)
            wrong += wrong_[k], holding += holds[k], both += wrong_[k] && holds[k];
        const double good = double(holds.size()) - wrong, spared = (good - (holding - both)) / good;
        return holding > 0 && wrong > 0 && spared > 0.8 ? std::min(both / wrong, both / holding) : 0;
    }

    /// That all wrong calls are along an axis is no chance, even where some others are.
    double score_alone(const Feature& one) const {
        constexpr double most_of_them = 0.8;
        const double s = score(one.holds);
        bool are_all = one.is_of_axis;
        for (std::size_t k = 0; are_all && k < wrong_.size(); ++k) are_all = one.holds[k] || !wrong_[k];
        return are_all && s >= most_of_them ? std::max(s, share) : s;
    }

    void add(Feature feature) {
        std::size_t count = 0;
        for (std::size_t k = 0; k < calls_.size(); ++k) {
            feature.holds.push_back(feature.test(calls_.rows[k], calls_.layouts[k], calls_.right[k]));
            count += feature.holds.back();
        }
        if (count > 0 && count < calls_.size()) list_.push_back(std::move(feature));
    }

    /// Whether a quantity has more than a few values, in right calls as in wrong ones: else any may tell them by
    /// chance.
    bool varies(const std::vector<double>& x, bool is_length) const {
        constexpr std::size_t few = 4;
        std::set<double> good, bad;
        for (std::size_t k = 0; k < x.size(); ++k)
            if (!std::isnan(x[k])) (wrong_[k] ? bad : good).insert(x[k]);
        // of a length, 1 is one value as well, whatever its rounding
        const auto is_one = [is_length](const std::set<double>& y) {
            const bool is_unit =
                is_length && !y.empty() && std::abs(*y.begin() - 1) < 1e-9 && std::abs(*y.rbegin() - 1) < 1e-9;
            return is_unit || (y.size() == 1 && (*y.begin() == 0 || std::isinf(*y.begin())));
        };
        return (good.size() >= few && (bad.size() >= few || is_one(bad))) || (bad.size() >= few && is_one(good));
    }

    /// Above or below what tells best, rounded.
    void threshold(const Quantity& q, const std::vector<double>& x) {
        std::vector<std::pair<double, bool>> sorted;
        for (std::size_t k = 0; k < x.size(); ++k)
            if (std::isfinite(x[k])) sorted.emplace_back(x[k], wrong_[k]);
        if (sorted.size() < 2 * at_least) return;
        std::ranges::sort(sorted);
        double best = 0, low = 0, high = 0;
        double total = 0, seen = 0;
        for (const auto& [value, bad] : sorted) total += bad;
        bool above = false;
        for (std::size_t i = 1; i < sorted.size(); ++i) {
            seen += sorted[i - 1].second;
            if (sorted[i].first == sorted[i - 1].first || total == 0) continue;
            const double n = double(sorted.size());
            const double below = std::min(seen / total, seen / double(i)),
                         over = std::min((total - seen) / total, (total - seen) / (n - double(i)));
            if (std::max(below, over) > best)
                best = std::max(below, over), above = over > below, low = sorted[i - 1].first, high = sorted[i].first;
        }
        if (best < 0.8) return;
        const bool to_zero = above ? high == 0 : low == 0;  // and 0 is one of them
        // the shortest number in between; one that nobody writes is chance
        std::optional<double> cut = to_zero || (low < 0 && high > 0) ? std::optional(0.0) : std::nullopt;
        for (int digits = 1; digits < 3 && !cut; ++digits) {
            // as near as can be to what is still right
            for (const double x : {above ? low : high, (low + high) / 2})
                if (const double short_one = rounded(x, digits); !cut && short_one >= low && short_one <= high)
                    cut = short_one;
        }
        if (!cut) return;
        const auto test = [f = q.value, above, low, high](const Row& row, const Layout& l, const Row& right) {
            return above ? f(row, l, right) >= high : f(row, l, right) <= low;
        };
        add({fmt::format("`{} {}{} {}`", q.words, above ? ">" : "<", to_zero ? "=" : "", number_in_words(*cut)), test,
             false, q.words});
    }

    void quantities() {
        auto all = quantities_of(calls_.layouts.front(), told_);
        for (Quantity& q : mirrored()) all.push_back(std::move(q));
        for (const Quantity& q : all) {
            std::vector<double> x;
            for (std::size_t k = 0; k < calls_.size(); ++k)
                x.push_back(q.value(calls_.rows[k], calls_.layouts[k], calls_.right[k]));
            const bool is_length = q.kind == Quantity::Kind::length;
            if (!varies(x, is_length)) continue;
            const auto f = q.value;
            const auto number = [&](const char* words, auto holds, const std::string& not_unit = {}) {
                const auto test = [f, holds](const Row& row, const Layout& l, const Row& right) {
                    return holds(f(row, l, right));
                };
                add({fmt::format(fmt::runtime(words), q.words), test, false, q.words, not_unit});
            };
            number("`{} < 0`", [](double y) { return y < 0; });
            number("`{} > 0`", [](double y) { return y > 0; });
            number("`{} = 0`", [](double y) { return y == 0; });
            number("`{} = inf`", [](double y) { return y == rt::inf; });
            if (is_length)
                number(
                    "`{}` is not 1", [](double y) { return std::abs(y - 1) > 1e-6; }, q.vector);
            threshold(q, x);
            if (std::ranges::any_of(x, [](double y) { return y < 0; }) && !is_length) {
                const Quantity size{
                    fmt::format("abs({})", q.words),
                    [f](const Row& row, const Layout& l, const Row& right) { return std::abs(f(row, l, right)); }};
                for (double& y : x) y = std::abs(y);
                threshold(size, x);
            }
        }
        const auto is_plain = [&](std::size_t i) { return all[i].kind == Quantity::Kind::number; };
        // a random number is compared with another one alone
        const auto is_random = [&](std::size_t i) { return all[i].words == "u" || all[i].words.starts_with("u."); };
        for (std::size_t a = 0; a < all.size(); ++a)
            for (std::size_t b = 0; b < all.size(); ++b)
                if (a != b && is_plain(a) && is_plain(b) && is_random(a) == is_random(b))
                    add({fmt::format("`{} < {}`", all[a].words, all[b].words),
                         [f = all[a].value, g = all[b].value](const Row& row, const Layout& l, const Row& right) {
                             return f(row, l, right) < g(row, l, right);
                         },
                         false, all[a].words});
    }

    /// Of a direction that is mirrored at another: its cosine with a third one.
    std::vector<Quantity> mirrored() const {
        std::vector<Quantity> all;
        for (const Direction& one : directions_)
            for (const Direction& third : directions_) {
                const bool is_third = one.parts.size() == 2 && third.parts.size() == 1 &&
                                      one.parts[0] < third.parts[0] && one.parts[1] != third.parts[0];
                if (!is_third) continue;
                all.push_back({fmt::format("dot({}, {})", one.code, third.code),
                               [a = one.value, b = third.value](const Row& row, const Layout& l, const Row&) {
                                   return rt::dot(a(row, l), b(row, l));
                               },
                               Quantity::Kind::product});
            }
        return all;
    }

    const Calls& calls_;
    std::vector<bool> wrong_, told_;
    std::vector<Direction> directions_;
    std::vector<Feature> list_;
};

}  // namespace

WrongCalls rule_of(const Calls& calls, bool of_answers) { return Features(calls, of_answers).rule(); }

}  // namespace grade
