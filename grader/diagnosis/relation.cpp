#include "diagnosis/relation.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/changes.h"
#include "diagnosis/families.h"
#include "diagnosis/forms.h"
#include "diagnosis/where.h"

namespace grade {

namespace {

constexpr std::size_t enough = 5;       // wrong calls, below which anything may be chance
constexpr std::size_t few = 10;         // calls with which two changes at once are sifted
constexpr std::size_t most_pairs = 36;  // changes that are tried by twos
constexpr std::size_t most_pairs_of_steps = 150;
constexpr double best_cost = 100;

std::string named(const Field& part) { return part.name.empty() ? "the answer" : "`" + part.name + "`"; }

class Search {
public:
    Search(const Calls& calls, const Ask& right, bool sampled) : calls_(calls), ask_(right), sampled_(sampled) {
        for (std::size_t k = 0; k < calls.size(); ++k) {
            all_.push_back(k);
            if (!is_equal(calls.result, calls.mine[k], calls.right[k])) wrong_.push_back(k);
        }
        for (const Field& part : calls.result.parts)
            for (const std::size_t k : wrong_)
                if (counts(calls.result, part, calls.mine[k], calls.right[k]) &&
                    !is_equal(part, calls.mine[k], calls.right[k])) {
                    parts_.push_back(&part);
                    break;
                }
        changes_ = changes_of(calls.layouts.front(), calls.told, calls.changeable);
    }

    std::optional<Relation> run(bool& right_otherwise) {
        right_otherwise = false;
        if (wrong_.size() < enough) return std::nullopt;
        const auto bases = same_sampling(calls_.layouts.front());
        for (const Change& base : bases)
            if (const auto right = sampled_ ? answers(base, nullptr, all_) : std::nullopt;
                right && all_equal(*right, all_)) {
                right_otherwise = true;
                return std::nullopt;
            }
        for (const Change& base : bases) {
            if (!sampled_ && &base != &bases.front()) break;
            const auto right = answers(base, nullptr, all_);
            if (!right) continue;
            consider(*right, {}, base.cost, all_, false);
            one_change(base, all_);
            if (best_) return best_;
        }
        one_constant(all_);
        if (best_) return best_;
        if (auto there = by_choice()) return there;
        const bool is_flag = calls_.result.parts.front().kind == Kind::flag;  // true and false agree by chance
        const bool some_right = wrong_.size() < all_.size() && !sampled_ && !is_flag;
        Region there;
        if (some_right) {
            consider(calls_.right, {}, 0, wrong_, false);
            // a change that would spoil right calls is no cause, unless it is known which calls it is made in
            there = where_wrong(calls_);
            if (there.is_exact) {
                region_ = there.words + ", ";
                one_change(bases.front(), wrong_);
                if (!best_) one_constant(wrong_);
                region_.clear();
            }
            if (best_) return best_;
        }
        if (!sampled_)
            if (auto there = where_it_is_not_nothing()) return there;
        two_changes(all_);
        if (best_) return best_;
        if (there.is_exact) {
            region_ = there.words + ", ";
            two_changes(wrong_);
            region_.clear();
        }
        if (!best_) one_of_several();
        if (best_ || !calls_.changeable.empty()) return best_;
        return by_parts();
    }

private:
    /// One mistake in calls of one kind, or of some: of a disc, say.
    std::optional<Relation> by_choice() const {
        const auto& parts = calls_.layouts.front().parts;
        // true and false agree by chance
        if (calls_.result.parts.front().kind == Kind::flag) return std::nullopt;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if ((parts[i].kind != Kind::choice && parts[i].kind != Kind::flag) || !calls_.told[i]) continue;
            std::optional<Relation> first;
            std::string kinds;
            bool is_all = true;
            for (int value = 0; value < 5; ++value) {
                const Calls some = those_of(
                    calls_, [&](std::size_t k) { return calls_.rows[k][calls_.layouts[k].parts[i].at] == value; });
                if (some.size() == 0 || some.size() == calls_.size()) continue;
                Search search(some, ask_, sampled_);
                if (search.wrong_.empty()) continue;
                const auto found = search.one_mistake();
                const bool is_same = found && (!first || first->words == found->words);
                is_all = is_all && is_same;
                if (!is_same) continue;
                if (!first) first = found;
                kinds +=
                    (kinds.empty() ? "" : " or ") + value_in_words({parts[i].name, parts[i].kind, 0}, {double(value)});
            }
            if (!first) continue;
            first->words = fmt::format("where `{}` is {}, {}", parts[i].name, kinds, first->words);
            if (!is_all) first->words += "; other calls are wrong as well";
            first->everywhere = false;
            return first;
        }
        return std::nullopt;
    }

    std::optional<Relation> one_mistake() {
        if (wrong_.size() < enough) return std::nullopt;
        for (const Change& base : same_sampling(calls_.layouts.front())) {
            if (!sampled_ && base.cost > 0) break;
            const auto right = answers(base, nullptr, all_);
            if (!right || all_equal(*right, all_)) continue;
            consider(*right, {}, base.cost, all_, false);
            one_change(base, all_);
            if (best_) return best_;
        }
        one_constant(all_);
        return best_;
    }

    /// One change where the right answer is neither 0 nor inf: what happens there may be a second mistake.
    std::optional<Relation> where_it_is_not_nothing() {
        std::vector<std::size_t> some;
        for (const std::size_t k : all_)
            if (is_something(calls_.right[k]) && !is_void(calls_.result, calls_.right[k])) some.push_back(k);
        if (some.size() < 2 * enough || some.size() == all_.size()) return std::nullopt;
        region_ = "where the right answer is not 0 or inf, ";
        one_change(same_, some);
        region_.clear();
        return best_;
    }

    /// The right answers for changed arguments, to the calls of `scope`.
    std::optional<Rows> answers_in(const Change& first, const Change* second,
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

    /// Elsewhere, those that are right.
    std::optional<Rows> answers(const Change& first, const Change* second,
                                const std::vector<std::size_t>& scope) const {
        auto given = answers_in(first, second, scope);
        if (!given) return given;
        Rows all = calls_.right;
        for (std::size_t i = 0; i < scope.size(); ++i) all[scope[i]] = std::move((*given)[i]);
        return all;
    }

    bool all_equal(const Rows& right, const std::vector<std::size_t>& scope) const {
        return std::ranges::all_of(scope,
                                   [&](std::size_t k) { return is_equal(calls_.result, calls_.mine[k], right[k]); });
    }

    /// A relation of all parts that are wrong, if it costs less than the best one.
    void consider(const Rows& right, const std::string& change, double cost, const std::vector<std::size_t>& scope,
                  bool only_simple, const std::string& usually = {}) {
        std::string forms;
        for (const Field* part : parts_) {
            const auto form = form_of(calls_, *part, right, scope, only_simple);
            // a change and a constant together explain much by chance
            if (!form || (!change.empty() && parts_.size() < 2 && !form->words.empty())) return;
            cost += form->cost;
            if (!form->words.empty())
                forms += fmt::format("{}{} {}", forms.empty() ? "" : ", and ", named(*part), form->words);
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
        const std::string there = !region_.empty() ? region_ : everywhere ? "" : "in the wrong calls ";
        best_ = Relation{there + sentence(change, forms), forms.empty() ? usually : "", everywhere, cost,
                         Relation::Explains::all};
    }

    static std::string sentence(const std::string& change, const std::string& forms) {
        if (change.empty()) return forms;
        const std::string as = std::string(as_changed) + change;
        return forms.empty() ? as : fmt::format("{}, but {}", as, forms);
    }

    /// Whether the changed answers differ from right ones as often as mine do, and not by one number only, unless it is
    /// told in which calls they are left as they are.
    bool tells(const Rows& changed, const std::vector<std::size_t>& scope) const {
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
        if (other < enough) return false;
        const bool is_number = std::ranges::none_of(*first, [](double x) { return std::isnan(x); });
        return varies || (is_number && other >= 2 * enough && left >= enough);
    }

    static bool is_something(const Row& answer) {
        return std::ranges::any_of(answer, [](double x) { return std::isfinite(x) && x != 0; });
    }

    /// Calls with which a change is sifted.
    std::vector<std::size_t> some_wrong(const std::vector<std::size_t>& scope) const {
        std::vector<std::size_t> wrong, sample;
        for (const std::size_t k : scope)
            if (!is_equal(calls_.result, calls_.mine[k], calls_.right[k])) wrong.push_back(k);
        const std::size_t count = std::min(few, wrong.size());
        for (std::size_t i = 0; i < count; ++i) sample.push_back(wrong[i * wrong.size() / count]);
        return sample;
    }

    bool may_be(const Rows& right, const std::vector<std::size_t>& sample) const {
        return sample.empty() || std::ranges::all_of(parts_, [&](const Field* part) {
                   return form_of(calls_, *part, right, sample, true).has_value();
               });
    }

    void one_change(const Change& base, const std::vector<std::size_t>& scope) {
        const auto sample = some_wrong(scope);
        for (const Change& change : changes_) {
            if (best_ && change.cost + base.cost >= best_->cost) break;
            if (const auto some = answers(change, &base, sample); !some || !may_be(*some, sample)) continue;
            const auto right = answers(change, &base, scope);
            if (right && tells(*right, scope))
                consider(*right, change.words, change.cost + base.cost, scope, true, change.usually);
        }
    }

    void one_constant(const std::vector<std::size_t>& scope) {
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

    /// The calls with other random numbers. None: hardly any of the answers is right with these, and they are others.
    std::optional<Calls> with_base(const Change& base) const {
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

    /// The change that explains most of the wrong calls, where it explains nearly all that it changes: the rest is
    /// another mistake.
    void one_of_several() {
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
            for (const std::size_t k : all_) {
                if (is_equal(calls_.result, (*right)[k], calls_.right[k])) continue;
                const bool equal = is_equal(calls_.result, (*right)[k], calls_.mine[k]);
                ++changed, same += equal;
                // nothing, or something, may be right for many reasons
                telling += equal && is_something(calls_.mine[k]) && is_something(calls_.right[k]);
            }
            const bool explains = double(same) >= share_of_wrong * double(wrong_.size()) &&
                                  double(same) >= share_of_changed * double(changed);
            if (!explains || telling < least || same <= most) continue;
            most = same;
            const bool are_all = same == wrong_.size();
            best_ = Relation{
                fmt::format("in {} wrong calls the answers are exactly what the right fragment answers "
                            "with {}{}",
                            are_all ? fmt::format("all {}", same) : fmt::format("{} of {}", same, wrong_.size()),
                            change.words, are_all ? "" : other_mistakes),
                {},
                false,
                best_cost,
                Relation::Explains::some};
            best_->share = double(same) / double(wrong_.size());
        }
    }

    bool is_same_in(const Change& first, const Change& second, const std::vector<std::size_t>& scope) const {
        const auto some = answers_in(first, &second, scope);
        for (std::size_t i = 0; some && i < scope.size(); ++i)
            if (!is_equal(calls_.result, calls_.mine[scope[i]], (*some)[i])) return false;
        return some.has_value();
    }

    /// Whether two changes put something in place of the same: nobody makes both.
    static bool are_of_one(const Change& first, const Change& second) {
        constexpr std::string_view in_place = " in place of ";
        const std::size_t at = first.words.rfind(in_place), other = second.words.rfind(in_place);
        return at != std::string::npos && other != std::string::npos &&
               std::string_view(first.words).substr(at) == std::string_view(second.words).substr(other);
    }

    void two_changes(const std::vector<std::size_t>& scope) {
        // sifted: which part of the calls tells them apart
        std::vector<std::size_t> sample;
        for (const std::size_t k : wrong_)
            if (sample.size() < few) sample.push_back(k);
        std::vector<const Change*> list;
        const bool of_steps = !calls_.changeable.empty();
        for (const Change& change : changes_) {
            if (list.size() >= (of_steps ? most_pairs_of_steps : most_pairs)) break;
            if (change.cost > 1.5) break;
            const auto right = answers(change, nullptr, sample);
            if (right && std::ranges::any_of(sample, [&](std::size_t k) {
                    return !is_equal(calls_.result, (*right)[k], calls_.right[k]);
                }))
                list.push_back(&change);
        }
        for (std::size_t a = 0; a < list.size(); ++a)
            for (std::size_t b = 0; b < list.size(); ++b) {
                const double cost = list[a]->cost + list[b]->cost + 1;
                if (a == b || (best_ && cost >= best_->cost) || are_of_one(*list[a], *list[b])) continue;
                if (of_steps && !is_same_in(*list[a], *list[b], {sample.front()})) continue;
                if (!is_same_in(*list[a], *list[b], sample)) continue;
                const auto right = answers(*list[a], list[b], scope);
                if (right && tells(*right, scope))
                    consider(*right, list[a]->words + ", and " + list[b]->words, cost, scope, true);
            }
    }

    /// Each part by itself; what is found of some.
    std::optional<Relation> by_parts() const {
        std::string words;
        std::size_t explained = 0;
        for (const Field* part : parts_) {
            const auto is_wrong = [&](std::size_t k) {
                return counts(calls_.result, *part, calls_.mine[k], calls_.right[k]) &&
                       !is_equal(*part, calls_.mine[k], calls_.right[k]);
            };
            if (std::ranges::count_if(wrong_, is_wrong) < std::ptrdiff_t(2 * enough)) continue;
            double best = best_cost;
            std::string found;
            if (const auto form = form_of(calls_, *part, calls_.right, all_, false); form && !sampled_)
                best = form->cost, found = fmt::format("{} {}", named(*part), form->words);
            for (const Change& change : changes_) {
                if (change.cost >= best || calls_.result.parts.size() < 2) break;
                const auto right = answers(change, nullptr, all_);
                if (!right || !tells(*right, all_)) continue;
                // what counts for nothing explains nothing
                if (std::ranges::any_of(
                        wrong_, [&](std::size_t k) { return is_wrong(k) && is_void(calls_.result, (*right)[k]); }))
                    continue;
                if (const auto form = form_of(calls_, *part, *right, all_, true); form && form->words.empty())
                    best = change.cost, found = fmt::format("{} is exactly what the right fragment answers with {}",
                                                            named(*part), change.words);
            }
            if (found.empty()) continue;
            words += (words.empty() ? "" : "; ") + found, ++explained;
        }
        if (!words.empty()) {
            Relation some{words, {}, true, best_cost, Relation::Explains::some};
            some.share = double(explained) / double(2 * parts_.size());
            return some;
        }
        // where a direction is right, the random numbers are used as the solution does, and what is wrong is wrong; the
        // other way round, another direction may be as good
        if (parts_.size() == calls_.result.parts.size() ||
            std::ranges::any_of(parts_, [&](const Field* part) { return is_place(*part); }))
            return std::nullopt;
        std::string good;
        for (const Field& part : calls_.result.parts)
            if (std::ranges::count(parts_, &part) == 0) good += (good.empty() ? "" : ", ") + named(part);
        for (const Field* part : parts_) words += (words.empty() ? "" : ", ") + named(*part);
        return Relation{
            fmt::format("{} {} right, {} {} not", good, calls_.result.parts.size() - parts_.size() > 1 ? "are" : "is",
                        words, parts_.size() > 1 ? "are" : "is"),
            {},
            true,
            best_cost,
            Relation::Explains::nothing,
            false,
            0};
    }

    const Calls& calls_;
    const Ask& ask_;
    bool sampled_;
    std::string region_;  // of which a relation is looked for: "where ..., "
    const Change same_{"", 0, [](Row&, const Layout&) { return true; }, {}};
    std::vector<std::size_t> all_, wrong_;
    std::vector<const Field*> parts_;  // of the answer, that are wrong somewhere
    std::vector<Change> changes_;
    std::optional<Relation> best_;
};

}  // namespace

std::optional<Relation> relation_of(const Calls& calls, const Ask& right, bool sampled, bool& right_otherwise) {
    return Search(calls, right, sampled).run(right_otherwise);
}

}  // namespace grade
