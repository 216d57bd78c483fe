#include "diagnosis/changes/answer_forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "diagnosis/changes/constants.h"
#include "diagnosis/changes/products.h"
#include "rt/math.h"

namespace grade {

namespace {

class Forms {
public:
    explicit Forms(const PartOfCalls& of)
        : of_(of), calls_(of.calls), part_(of.part), right_(of.right_rows), scope_(of.scope), size_(of.size()) {}

    std::optional<AnswerForm> simple() const {
        if (equals([&](std::size_t k, std::size_t c) { return right(k, c); })) return AnswerForm{};
        if (equals([&](std::size_t k, std::size_t c) { return -right(k, c); }))
            return AnswerForm{part_.kind == Kind::vector ? "points the opposite way" : "has the opposite sign", 1};
        auto form = factor();
        return form ? form : not_unit();
    }

    std::optional<AnswerForm> any() const {
        if (auto form = simple(); form && form->kind != AnswerForm::Kind::not_unit) return form;
        if (auto form = first_of(*this)) return form;
        // logarithms of what is not 0; what is 0 may be a second mistake, but not most of it
        std::vector<std::size_t> shining;
        std::size_t wrong = 0, wrong_shining = 0;
        for (const std::size_t k : scope_) {
            const bool is_wrong = !is_equal(part_, calls_.mine[k], right_[k]);
            bool shines = false;
            for (std::size_t c = 0; c < size_; ++c) shines = shines || (mine(k, c) != 0 && right(k, c) != 0);
            if (shines) shining.push_back(k);
            wrong += is_wrong, wrong_shining += is_wrong && shines;
        }
        const PartOfCalls some{calls_, part_, right_, shining};
        const bool fewer = shining.size() > 8 && shining.size() < scope_.size() && 2 * wrong_shining > wrong;
        if (fewer) {
            auto form = Forms(some).simple();
            if (!form || form->words.empty()) form = first_of(Forms(some));
            const bool is_constant = form && form->kind == AnswerForm::Kind::constant;
            if (form)
                return AnswerForm{form->words + " where it is not 0", form->cost + 0.4,
                                  is_constant ? form->kind : AnswerForm::Kind::other};
        }
        const PartOfCalls& lit = fewer ? some : of_;
        for (const auto& look : {quantity_of, product_of, difference_of})
            if (auto form = look(lit)) return form;
        return std::nullopt;
    }

private:
    static std::optional<AnswerForm> first_of(const Forms& forms) {
        for (const auto& look : {&Forms::constant_value, &Forms::rearranged, &Forms::own_function, &Forms::other_part,
                                 &Forms::with_argument})
            if (auto form = (forms.*look)()) return form;
        return std::nullopt;
    }

    double mine(std::size_t k, std::size_t c) const { return of_.mine(k, c); }
    double right(std::size_t k, std::size_t c) const { return of_.right(k, c); }

    template <class F>
    bool equals(F expected) const {
        return of_.equals(expected);
    }

    std::optional<AnswerForm> factor() const {
        double most = 0, ratio = 0;
        for (const std::size_t k : scope_)
            for (std::size_t c = 0; c < size_; ++c)
                if (std::isfinite(right(k, c)) && std::isfinite(mine(k, c)) && std::abs(right(k, c)) > most)
                    most = std::abs(right(k, c)), ratio = mine(k, c) / right(k, c);
        // as near as that, anything is a factor
        constexpr double clearly = 5 * equal_within;
        if (ratio == 0 || std::abs(ratio - 1) < clearly ||
            !equals([&](std::size_t k, std::size_t c) { return ratio * right(k, c); }))
            return std::nullopt;
        const bool large = std::abs(ratio) > 1;
        return AnswerForm{fmt::format("is {} times too {}{}", constant(large ? std::abs(ratio) : 1 / std::abs(ratio)),
                                      large                        ? part_.kind == Kind::vector ? "long" : "large"
                                      : part_.kind == Kind::vector ? "short"
                                                                   : "small",
                                      ratio < 0 ? ", and has the opposite sign" : ""),
                          is_named(ratio) ? 1.3 : 2.2};
    }

    /// Of a vector that must have length 1, the right way, with other lengths.
    std::optional<AnswerForm> not_unit() const {
        if (part_.kind != Kind::vector) return std::nullopt;
        const auto length = [&](const Row& row) {
            return std::hypot(row[part_.at], row[part_.at + 1], row[part_.at + 2]);
        };
        const auto all = [&](auto holds) { return std::ranges::all_of(scope_, holds); };
        const bool is_other = all([&](std::size_t k) { return std::isfinite(length(calls_.mine[k])); }) &&
                              !all([&](std::size_t k) { return is_close(length(calls_.mine[k]), 1, 1, 1e-3); });
        if (!is_other || !all([&](std::size_t k) { return is_close(length(right_[k]), 1, 1); }) ||
            !equals([&](std::size_t k, std::size_t c) { return length(calls_.mine[k]) * right(k, c); }))
            return std::nullopt;
        return not_normalised();
    }

    static AnswerForm not_normalised() {
        return {"points the right way, but does not have length 1", 1.9, AnswerForm::Kind::not_unit};
    }

    std::optional<AnswerForm> constant_value() const {
        const std::size_t first = scope_.front();
        if (!equals([&](std::size_t, std::size_t c) { return mine(first, c); })) return std::nullopt;
        for (std::size_t c = 0; c < size_; ++c)
            if (std::isnan(mine(first, c))) return std::nullopt;
        const bool has_name = size_ == 1 && part_.kind == Kind::number && is_named(mine(first, 0));
        return AnswerForm{
            "is always " + (has_name ? constant(mine(first, 0)) : value_in_words(part_, calls_.mine[first])), 1.5,
            AnswerForm::Kind::constant};
    }

    /// By which factor, where the right one has a length.
    AnswerForm another_length() const {
        const auto is_long = [&](auto length) {
            return std::ranges::all_of(scope_, [&](std::size_t k) {
                return is_close(std::hypot(mine(k, 0), mine(k, 1), mine(k, 2)), length(k), 1);
            });
        };
        const auto is_right_long = [&](std::size_t k) {
            return is_close(std::hypot(right(k, 0), right(k, 1), right(k, 2)), 1, 1);
        };
        if (std::ranges::all_of(scope_, is_right_long)) {
            const auto& parts = calls_.layouts.front().parts;
            const auto told = told_of(calls_, scope_);
            for (std::size_t i = 0; i < parts.size(); ++i) {
                if (parts[i].kind != Kind::number || !told[i]) continue;
                const auto number = [&](std::size_t k) { return calls_.rows[k][calls_.layouts[k].parts[i].at]; };
                // where it is infinite, nothing has that length
                const bool is_finite = std::ranges::any_of(scope_, [&](auto k) { return std::isfinite(number(k)); });
                if (is_finite && is_long([&](std::size_t k) {
                        return std::isfinite(number(k)) ? number(k) : std::hypot(mine(k, 0), mine(k, 1), mine(k, 2));
                    }))
                    return AnswerForm{
                        fmt::format("points the right way, but is `{}` long: its length must be 1", parts[i].name),
                        1.5};
            }
            return not_normalised();
        }
        std::vector<std::size_t> some;
        for (const std::size_t k : scope_)
            if (right(k, 0) != 0 || right(k, 1) != 0 || right(k, 2) != 0) some.push_back(k);
        const PartOfCalls long_ones{calls_, part_, right_, some};
        return product_of(long_ones).value_or(AnswerForm{"points the right way, but has another length", 1.9});
    }

    std::optional<AnswerForm> rearranged() const {
        if (part_.kind == Kind::vector && equals([&](std::size_t k, std::size_t c) {
                const rt::vec3 v(right(k, 0), right(k, 1), right(k, 2));
                return rt::unit(v)[int(c)];
            }))
            return AnswerForm{"has length 1, whatever its length must be", 1.5};
        if (part_.kind == Kind::vector && equals([&](std::size_t k, std::size_t c) {
                const rt::vec3 v(mine(k, 0), mine(k, 1), mine(k, 2)), r(right(k, 0), right(k, 1), right(k, 2));
                const double length = std::sqrt(rt::dot(v, v) / std::max(rt::dot(r, r), 1e-300));
                return std::isfinite(length) ? length * r[int(c)] : rt::inf;
            }))
            return another_length();
        if (size_ < 2) return std::nullopt;
        constexpr std::array<const char*, 3> axis = {"x", "y", "z"}, channel = {"red", "green", "blue"};
        const auto& names = part_.kind == Kind::color ? channel : axis;
        for (std::size_t a = 0; a < size_; ++a) {
            for (std::size_t b = 0; b < size_; ++b)
                if (a != b && equals([&](std::size_t k, std::size_t c) { return right(k, c == a ? b : c); }))
                    return AnswerForm{fmt::format("has in {} what belongs into {}", names[a], names[b]), 1.5};
            if (part_.kind != Kind::color &&
                equals([&](std::size_t k, std::size_t c) { return c == a ? -right(k, c) : right(k, c); }))
                return AnswerForm{fmt::format("has the opposite sign in {}", names[a]), 1.5};
            for (std::size_t b = a + 1; b < size_; ++b)
                if (equals([&](std::size_t k, std::size_t c) { return right(k, c == a ? b : c == b ? a : c); }))
                    return AnswerForm{fmt::format("has {} and {} exchanged", names[a], names[b]), 1.5};
            if (equals([&](std::size_t k, std::size_t) { return right(k, a); }))
                return AnswerForm{fmt::format("has everywhere what belongs into {} alone", names[a]), 1.6};
        }
        return std::nullopt;
    }

    std::optional<AnswerForm> own_function() const {
        const auto is = [&](double (*f)(double)) {
            return equals([&](std::size_t k, std::size_t c) { return f(right(k, c)); });
        };
        bool has_negative = false;
        for (const std::size_t k : scope_)
            for (std::size_t c = 0; c < size_; ++c) has_negative = has_negative || right(k, c) < 0;
        if (has_negative) {
            if (is([](double x) { return std::abs(x); })) return AnswerForm{"is never negative: the sign is lost", 1.5};
            if (is([](double x) { return std::max(x, 0.0); })) return AnswerForm{"is 0 where it must be negative", 1.5};
        }
        if (is([](double x) { return std::min(x, 1.0); })) return AnswerForm{"is cut off at 1", 1.5};
        if (has_negative && is([](double x) { return std::clamp(x, 0.0, 1.0); }))
            return AnswerForm{"is cut off at 0 and 1", 1.6};
        if (part_.kind == Kind::vector) return std::nullopt;
        if (is([](double x) { return x * x; })) return AnswerForm{"is the square of what it must be", 1.8};
        if (is([](double x) { return std::sqrt(x); })) return AnswerForm{"is the square root of what it must be", 1.8};
        if (is([](double x) { return 1 / x; })) return AnswerForm{"is 1 / x of what it must be", 1.8};
        if (is([](double x) { return 1 - x; })) return AnswerForm{"is 1 - x of what it must be", 1.8};
        return std::nullopt;
    }

    std::optional<AnswerForm> other_part() const {
        for (const Field& other : calls_.result.parts)
            if (other.at != part_.at && size_of(other.kind) == size_ &&
                equals([&](std::size_t k, std::size_t c) { return right_[k][other.at + c]; }))
                return AnswerForm{fmt::format("is what `{}` must be", other.name), 1.5};
        return std::nullopt;
    }

    std::optional<AnswerForm> with_argument() const {
        const auto& parts = calls_.layouts.front().parts;
        const auto told = told_of(calls_, scope_);
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (!told[i] || size_of(parts[i].kind) != size_ || parts[i].kind == Kind::flag ||
                parts[i].kind == Kind::choice)
                continue;
            const auto argument = [&](std::size_t k, std::size_t c) {
                return calls_.rows[k][calls_.layouts[k].parts[i].at + c];
            };
            const std::string& name = parts[i].name;
            if (equals(argument)) return AnswerForm{fmt::format("is `{}` itself", name), 1.5};
            if (equals([&](std::size_t k, std::size_t c) { return -argument(k, c); }))
                return AnswerForm{fmt::format("is `-{}` itself", name), 1.6};
            if (equals([&](std::size_t k, std::size_t c) { return right(k, c) - argument(k, c); }))
                return AnswerForm{fmt::format("is as if `{}` were not added, or taken away", name), 2};
            if (equals([&](std::size_t k, std::size_t c) { return right(k, c) + argument(k, c); }))
                return AnswerForm{fmt::format("is as if `{}` were added, or not taken away", name), 2};
        }
        return std::nullopt;
    }

    const PartOfCalls& of_;
    const Calls& calls_;
    const Field& part_;
    const Rows& right_;
    const std::vector<std::size_t>& scope_;
    std::size_t size_;
};

}  // namespace

std::optional<AnswerForm> form_of(const Calls& calls, const Field& part, const Rows& right,
                                  const std::vector<std::size_t>& scope, bool only_simple) {
    std::vector<std::size_t> counting;
    for (const std::size_t k : scope)
        if (counts(calls.result, part, calls.mine[k], right[k])) counting.push_back(k);
    if (counting.empty()) return AnswerForm{};
    const PartOfCalls of{calls, part, right, counting};
    return only_simple ? Forms(of).simple() : Forms(of).any();
}

}  // namespace grade
