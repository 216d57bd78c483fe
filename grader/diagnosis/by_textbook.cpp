#include "diagnosis/by_textbook.h"

#include <algorithm>
#include <ranges>
#include <span>

#include "diagnosis/asked.h"
#include "diagnosis/calls_made.h"
#include "diagnosis/surest.h"

namespace grade {

namespace {

constexpr std::size_t enough = 5;  // wrong calls
constexpr double dearest_of_pairs = 1.3;

/// Looks for mistakes in one form; the right answers are the form's.
class Textbook {
public:
    /// left: answers that it may ask for.
    Textbook(const Calls& calls, Asked& asked, std::size_t& left) : calls_(calls), asked_(asked), left_(left) {
        for (std::size_t k = 0; k < calls.size(); ++k)
            if (!is_equal(calls.result, calls.mine[k], calls.right[k])) wrong_.push_back(k);
        const std::size_t count = std::min<std::size_t>(6, wrong_.size());
        for (std::size_t i = 0; i < count; ++i) {
            sample_.push_back(wrong_[i * wrong_.size() / count]);
            asked_.answer(calls.rows[sample_[i]], calls.layouts[sample_[i]]);
            computed_.emplace_back();
            for (const textbook::Value& value : textbook::watch.values)
                computed_.back().push_back(value.kind != textbook::Value::Kind::none);
        }
    }

    std::size_t wrong() const { return wrong_.size(); }

    /// Whether any answer tells a mistake from others: that nothing is ever hit may have many reasons.
    bool tells() const {
        return calls_.result.parts.front().kind == Kind::flag || std::ranges::any_of(calls_.mine, is_something);
    }

    /// Whether a part of the answers is right in most wrong calls.
    bool has_right_part() const {
        return std::ranges::any_of(calls_.result.parts, [&](const Field& part) {
            const auto right = std::ranges::count_if(
                sample_, [&](std::size_t k) { return is_equal(part, calls_.mine[k], calls_.right[k]); });
            return 2 * std::size_t(right) > sample_.size();
        });
    }

    /// The simplest mistake that explains all, or the one that explains most of what is wrong.
    std::optional<Relation> one(bool or_of_arguments = false, double dearest = rt::inf) {
        std::optional<Relation> most;
        const std::vector<Change> changes =
            or_of_arguments ? changes_of(calls_.layouts.front(), calls_.told) : std::vector<Change>();
        const std::vector<Mistake> all = mistakes_and(changes);
        for (std::size_t i = 0; i < all.size() && all[i].cost <= dearest; ++i) {
            const Mistake& mistake = all[i];
            if (!may_explain(mistake)) continue;
            const double share = share_of(mistake);
            if (share == 1) return or_another(relation(mistake, 1), std::span(all).subspan(i));
            const bool is_condition =
                mistake.made.made == textbook::Made::yes || mistake.made.made == textbook::Made::no;
            if (is_condition) continue;  // a constant one explains some calls by chance
            if (share >= least_share && mistake.cost <= dearest_of_some && (!most || most->share < share))
                most = relation(mistake, share);
        }
        return most;
    }

    std::optional<Relation> two() {
        constexpr double dearest = dearest_of_pairs;
        const std::vector<Change> changes = changes_of(calls_.layouts.front(), calls_.told);
        std::vector<Mistake> all = mistakes_and(changes);
        std::erase_if(all, [&](const Mistake& m) { return m.cost > dearest || !changes_an_answer(m); });
        for (std::size_t b = 1; b < all.size(); ++b)
            for (std::size_t a = 0; a < b; ++a) {
                if (is_same_place(all[a], all[b])) continue;
                if (left_ == 0) return std::nullopt;
                if (!explain_all(all[a], all[b])) continue;
                Relation both{asked_.words_of(all[a]) + ", and " + asked_.words_of(all[b]), Relation::Kind::change};
                both.cost = all[a].cost + all[b].cost, both.by_textbook = true;
                return both;
            }
        return std::nullopt;
    }

private:
    static constexpr double least_share = 0.5, dearest_of_some = 1.3;

    /// Those of expressions and those of arguments, the simplest first.
    std::vector<Mistake> mistakes_and(const std::vector<Change>& changes) {
        std::vector<Mistake> all = asked_.mistakes_of(calls_);
        const auto count = std::ptrdiff_t(all.size());
        for (const Change& change : changes) all.push_back({"", "", change.cost, {}, "", &change});
        std::ranges::inplace_merge(all, all.begin() + count, {}, &Mistake::cost);  // both are in order
        return all;
    }

    /// Of operators and functions that nothing tells apart, the first two are told: they stand in different places.
    Relation or_another(Relation found, std::span<const Mistake> mistakes) {
        const auto is_alternative = [](const Mistake& m) { return m.made.alternative != 0; };
        const Mistake& first = mistakes.front();
        for (const Mistake& other : mistakes.subspan(1)) {
            if (!is_alternative(first) || other.cost > first.cost) break;
            if (!is_alternative(other) || is_same_place(first, other) || !may_explain(other) || share_of(other) < 1)
                continue;
            found.said += ", or " + asked_.words_of(other);
            break;
        }
        return found;
    }

    bool explains(std::size_t k, const Mistake& first, const Mistake* second = nullptr) {
        constexpr std::size_t usual = 64;  // values that are computed for an answer
        const Row answer = asked_.answer(calls_.rows[k], calls_.layouts[k], &first, second);
        left_ -= std::min(left_, 1 + textbook::watch.passed / usual);
        return is_answer(calls_.result, answer, calls_.mine[k]);
    }

    /// Whether it explains the first or the second call that it can change.
    bool may_explain(const Mistake& mistake) {
        int tried = 0;
        for (std::size_t i = 0; i < sample_.size() && tried < 2; ++i) {
            if (!mistake.of_arguments && !is_computed(i, mistake)) continue;
            ++tried;
            if (left_ == 0) return false;
            if (explains(sample_[i], mistake)) return true;
        }
        return false;
    }

    /// Whether the form computes one of its expressions in a call of the sample.
    bool is_computed(std::size_t i, const Mistake& mistake) const {
        return std::ranges::any_of(mistake.made.nodes,
                                   [&](int node) { return computed_[i][std::size_t(node - asked_.first())]; });
    }

    bool changes_an_answer(const Mistake& mistake) {
        return std::ranges::any_of(sample_, [&](std::size_t k) {
            return !is_answer(calls_.result, asked_.answer(calls_.rows[k], calls_.layouts[k], &mistake),
                              calls_.right[k]);
        });
    }

    static bool is_same_place(const Mistake& a, const Mistake& b) {
        if (a.of_arguments && b.of_arguments) return true;
        return std::ranges::any_of(a.made.nodes, [&](int node) { return b.made.is_of(node); });
    }

    /// Of the wrong calls; 0 where it breaks a right one.
    double share_of(const Mistake& mistake) {
        std::size_t equal = 0, something = 0;
        for (std::size_t k = 0; k < calls_.size(); ++k) {
            const bool is_explained = explains(k, mistake);
            const bool is_wrong = std::ranges::binary_search(wrong_, k);
            if (!is_explained && !is_wrong) return 0;
            equal += is_explained && is_wrong;
            something +=
                is_explained && is_wrong && is_something(calls_.mine[k]) && !is_void(calls_.result, calls_.mine[k]);
        }
        if (equal < wrong_.size() && 2 * something < equal + enough) return 0;  // nothing is right for many reasons
        return double(equal) / double(wrong_.size());
    }

    bool explain_all(const Mistake& first, const Mistake& second) {
        for (const std::size_t k : sample_)
            if (!explains(k, first, &second)) return false;
        for (std::size_t k = 0; k < calls_.size(); ++k)
            if (!explains(k, first, &second)) return false;
        return true;
    }

    Relation relation(const Mistake& mistake, double share) const {
        Relation found{asked_.words_of(mistake), Relation::Kind::change};
        found.edit = asked_.words_of(mistake, false), found.usually = mistake.usually;
        found.cost = mistake.cost, found.by_textbook = share == 1, found.share = share;
        if (share < 1) {
            found.calls = "in most wrong calls ", found.explains = Relation::Explains::some;
            found.others_remain = true;
        }
        return found;
    }

    const Calls& calls_;
    Asked& asked_;
    std::size_t& left_;
    std::vector<std::size_t> wrong_, sample_;
    std::vector<std::vector<bool>> computed_;  // by call of the sample, by node
};

/// visit(calls, form) with each form that the calls can be compared with.
template <class Visit>
void each_form(const Calls& calls, bool sampled, Visit visit) {
    for (const textbook::Form& form : textbook::forms()) {
        if (form.fragment != calls.signature.fragment || !form.says.empty() || calls.size() == 0) continue;
        Asked asked(form);
        if (const auto all = as_form_has(calls, asked, sampled)) visit(*all, asked);
    }
}

/// A form that is wrong as a whole, and answers as the calls do.
std::optional<Relation> known_mistake(const Calls& calls, bool sampled) {
    for (const textbook::Form& form : textbook::forms()) {
        if (form.fragment != calls.signature.fragment || form.says.empty()) continue;
        Asked asked(form);
        for (const Change& base : same_sampling(calls.layouts.front())) {
            if (base.cost > 0 && !sampled) break;
            std::size_t wrong = 0;
            const auto is_explained = [&](std::size_t k) {
                Row row = calls.rows[k];
                base.make(row, calls.layouts[k]);
                wrong += !is_equal(calls.result, calls.mine[k], calls.right[k]);
                return is_answer(calls.result, asked.answer(row, calls.layouts[k]), calls.mine[k]);
            };
            std::size_t k = 0;
            while (k < calls.size() && is_explained(k)) ++k;
            if (k < calls.size() || wrong < enough) continue;
            Relation found{form.says, Relation::Kind::named_mistake};
            found.cost = 1 + base.cost, found.by_textbook = true, found.has_other_order = form.has_other_order;
            return found;
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<Relation> relation_of_textbook(const Calls& calls, bool sampled, bool& right_otherwise,
                                             std::size_t& left) {
    if (calls.size() == 0) return std::nullopt;
    if (auto known = known_mistake(calls, sampled)) return known;
    std::optional<Relation> best, some;
    each_form(calls, sampled, [&](const Calls& own, Asked& asked) {
        for (const Change& base : same_sampling(own.layouts.front())) {
            if (base.cost > 0 && (!sampled || best)) break;
            const Calls all = base.cost > 0 ? with_numbers(own, base, asked) : own;
            Textbook textbook(all, asked, left);
            const bool is_of_all = own.size() == calls.size();  // else what is left out may be wrong
            right_otherwise = right_otherwise || (sampled && is_of_all && textbook.wrong() == 0);
            if (textbook.wrong() < enough || right_otherwise || !textbook.tells()) continue;
            if (base.cost > 0 && !textbook.has_right_part()) continue;
            auto found = textbook.one();
            if (!found) continue;
            found->cost += base.cost, found->other_numbers = base.cost > 0;
            if (found->explains != Relation::Explains::all) {
                if (base.cost == 0 && (!some || some->share < found->share)) some = std::move(found);
            } else if (!best || best->cost > found->cost) {
                best = std::move(found);
            }
        }
    });
    if (!best && !right_otherwise)
        best = by_kinds(calls, [&](const Calls& of_one_kind) {
            std::optional<Relation> found;
            each_form(of_one_kind, false, [&](const Calls& own, Asked& asked) {
                Textbook textbook(own, asked, left);
                if (textbook.wrong() < enough || !textbook.tells()) return;
                auto one = textbook.one();
                if (is_exact(one) && (!found || found->cost > one->cost)) found = std::move(one);
            });
            return found;
        });
    return best ? best : some;
}

namespace {

/// A form that is wrong as a whole, with one more mistake in it.
std::optional<Relation> known_mistake_and_another(const Calls& calls, const textbook::Form& form, std::size_t& left) {
    Asked asked(form);
    const auto as_form = with_answers_of(asked, calls);
    if (!as_form) return std::nullopt;
    Textbook textbook(*as_form, asked, left);
    if (textbook.wrong() < enough) return std::nullopt;
    auto found = textbook.one(true, dearest_of_pairs);
    if (!is_exact(found)) return std::nullopt;
    found->said = form.says + ", and " + found->said, found->kind = Relation::Kind::named_mistake;
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
        Textbook textbook(own, asked, own_share);
        if (textbook.wrong() >= enough && textbook.tells()) best = textbook.two();
        left -= share - own_share;
    });
    for (const textbook::Form& form : textbook::forms()) {
        if (best || form.fragment != calls.signature.fragment || form.says.empty()) continue;
        best = known_mistake_and_another(calls, form, left);
    }
    return best;
}

}  // namespace grade
