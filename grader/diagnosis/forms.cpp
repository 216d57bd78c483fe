#include "diagnosis/forms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rt/math.h"

namespace grade {

std::string ratio_in_words(double ratio) {
    const double off = std::abs(ratio - 1);
    const int digits = off > 0 && off < 0.5 ? int(std::ceil(-std::log10(off))) + 2 : 3;
    return fmt::format("{:.{}g}", ratio, std::clamp(digits, 3, 12));
}

namespace {

struct Named {
    double value;
    const char* words;
};

constexpr Named constants[] = {{1, "1"},
                               {2, "2"},
                               {3, "3"},
                               {4, "4"},
                               {8, "8"},
                               {rt::pi, "pi"},
                               {2 * rt::pi, "2 pi"},
                               {4 * rt::pi, "4 pi"},
                               {rt::pi / 2, "pi / 2"},
                               {rt::pi * rt::pi, "pi^2"},
                               {180 / rt::pi, "180 / pi"},
                               {1.4142135623730951, "sqrt(2)"},
                               {1.7320508075688772, "sqrt(3)"},
                               {1.5, "3 / 2"}};

/// "pi", "1 / pi", or digits.
std::string constant(double x) {
    if (x < 0) return "-" + constant(-x);
    if (x == 0) return "0";
    for (const auto& [value, words] : constants) {
        if (std::abs(x / value - 1) < 3e-5) return words;
        const std::string name = words;
        if (std::abs(x * value - 1) < 3e-5) return "1 / " + (name.find(' ') == name.npos ? name : "(" + name + ")");
    }
    return ratio_in_words(x);
}

bool is_named(double x) {
    return std::ranges::any_of(constants, [=](const Named& n) {
        return std::abs(std::abs(x) / n.value - 1) < 3e-5 || std::abs(std::abs(x) * n.value - 1) < 3e-5;
    });
}

class Forms {
public:
    Forms(const Calls& calls, const Field& part, const Rows& right, const std::vector<std::size_t>& scope)
        : calls_(calls), part_(part), right_(right), scope_(scope), size_(size_of(part.kind)) {}

    std::optional<Form> simple() const {
        if (equals([&](std::size_t k, std::size_t c) { return right(k, c); })) return Form{};
        if (equals([&](std::size_t k, std::size_t c) { return -right(k, c); }))
            return Form{part_.kind == Kind::vector ? "points the opposite way" : "has the opposite sign", 1};
        return factor();
    }

    std::optional<Form> any() const {
        if (auto form = simple()) return form;
        for (const auto& look : {&Forms::constant_value, &Forms::rearranged, &Forms::own_function, &Forms::other_part,
                                 &Forms::with_argument})
            if (auto form = (this->*look)()) return form;
        // logarithms of what is not 0
        std::vector<std::size_t> shining;  // of what is not 0 everywhere
        for (const std::size_t k : scope_)
            for (std::size_t c = 0; c < size_; ++c)
                if (mine(k, c) != 0 || right(k, c) != 0) {
                    shining.push_back(k);
                    break;
                }
        const Forms some(calls_, part_, right_, shining);
        if (shining.size() > 8 && shining.size() < scope_.size())
            if (auto form = some.constant_value()) return Form{form->words + " where it is not 0", 1.9};
        if (auto form = some.of_quantity()) return form;
        return some.product();
    }

private:
    double mine(std::size_t k, std::size_t c) const { return calls_.mine[k][part_.at + c]; }
    double right(std::size_t k, std::size_t c) const { return right_[k][part_.at + c]; }

    template <class F>
    bool equals(F expected) const {
        for (const std::size_t k : scope_) {
            double scale = 1e-9;
            for (std::size_t c = 0; c < size_; ++c)
                if (std::isfinite(mine(k, c))) scale = std::max(scale, std::abs(mine(k, c)));
            for (std::size_t c = 0; c < size_; ++c)
                if (!is_close(mine(k, c), expected(k, c), scale)) return false;
        }
        return true;
    }

    std::optional<Form> factor() const {
        double most = 0, ratio = 0;
        for (const std::size_t k : scope_)
            for (std::size_t c = 0; c < size_; ++c)
                if (std::isfinite(right(k, c)) && std::isfinite(mine(k, c)) && std::abs(right(k, c)) > most)
                    most = std::abs(right(k, c)), ratio = mine(k, c) / right(k, c);
        if (ratio == 0 || !equals([&](std::size_t k, std::size_t c) { return ratio * right(k, c); }))
            return std::nullopt;
        const bool large = std::abs(ratio) > 1;
        return Form{fmt::format("is {} times too {}{}", constant(large ? std::abs(ratio) : 1 / std::abs(ratio)),
                                large                        ? part_.kind == Kind::vector ? "long" : "large"
                                : part_.kind == Kind::vector ? "short"
                                                             : "small",
                                ratio < 0 ? ", and has the opposite sign" : ""),
                    is_named(ratio) ? 1.3 : 2.2};
    }

    std::optional<Form> constant_value() const {
        const std::size_t first = scope_.front();
        if (!equals([&](std::size_t, std::size_t c) { return mine(first, c); })) return std::nullopt;
        if (size_ == 1 && part_.kind == Kind::number && is_named(mine(first, 0)))
            return Form{"is always " + constant(mine(first, 0)), 1.5};
        return Form{"is always " + value_in_words(part_, calls_.mine[first]), 1.5};
    }

    std::optional<Form> rearranged() const {
        if (part_.kind == Kind::vector && equals([&](std::size_t k, std::size_t c) {
                const rt::vec3 v(right(k, 0), right(k, 1), right(k, 2));
                return rt::unit(v)[int(c)];
            }))
            return Form{"has length 1, whatever its length must be", 1.5};
        if (part_.kind == Kind::vector && equals([&](std::size_t k, std::size_t c) {
                const rt::vec3 v(mine(k, 0), mine(k, 1), mine(k, 2)), r(right(k, 0), right(k, 1), right(k, 2));
                return (r * (std::sqrt(rt::dot(v, v) / std::max(rt::dot(r, r), 1e-300))))[int(c)];
            }))
            return Form{"points the right way, but has another length", 1.9};
        if (size_ < 2) return std::nullopt;
        constexpr std::array<const char*, 3> axis = {"x", "y", "z"}, channel = {"red", "green", "blue"};
        const auto& names = part_.kind == Kind::color ? channel : axis;
        for (std::size_t a = 0; a < size_; ++a) {
            if (part_.kind != Kind::color &&
                equals([&](std::size_t k, std::size_t c) { return c == a ? -right(k, c) : right(k, c); }))
                return Form{fmt::format("has the opposite sign in {}", names[a]), 1.5};
            for (std::size_t b = a + 1; b < size_; ++b)
                if (equals([&](std::size_t k, std::size_t c) { return right(k, c == a ? b : c == b ? a : c); }))
                    return Form{fmt::format("has {} and {} exchanged", names[a], names[b]), 1.5};
            if (equals([&](std::size_t k, std::size_t) { return right(k, a); }))
                return Form{fmt::format("has everywhere what belongs into {} alone", names[a]), 1.6};
        }
        return std::nullopt;
    }

    std::optional<Form> own_function() const {
        const auto is = [&](double (*f)(double)) {
            return equals([&](std::size_t k, std::size_t c) { return f(right(k, c)); });
        };
        if (is([](double x) { return std::abs(x); })) return Form{"is never negative: the sign is lost", 1.5};
        if (is([](double x) { return std::max(x, 0.0); })) return Form{"is 0 where it must be negative", 1.5};
        if (is([](double x) { return std::min(x, 1.0); })) return Form{"is cut off at 1", 1.5};
        if (is([](double x) { return std::clamp(x, 0.0, 1.0); })) return Form{"is cut off at 0 and 1", 1.6};
        if (part_.kind == Kind::vector) return std::nullopt;
        if (is([](double x) { return x * x; })) return Form{"is the square of what it must be", 1.8};
        if (is([](double x) { return std::sqrt(x); })) return Form{"is the square root of what it must be", 1.8};
        if (is([](double x) { return 1 / x; })) return Form{"is 1 / x of what it must be", 1.8};
        if (is([](double x) { return 1 - x; })) return Form{"is 1 - x of what it must be", 1.8};
        return std::nullopt;
    }

    std::optional<Form> other_part() const {
        for (const Field& other : calls_.result.parts)
            if (other.at != part_.at && size_of(other.kind) == size_ &&
                equals([&](std::size_t k, std::size_t c) { return right_[k][other.at + c]; }))
                return Form{fmt::format("is what `{}` must be", other.name), 1.5};
        return std::nullopt;
    }

    std::optional<Form> with_argument() const {
        const auto& parts = calls_.layouts.front().parts;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            if (size_of(parts[i].kind) != size_ || parts[i].kind == Kind::flag || parts[i].kind == Kind::choice)
                continue;
            const auto argument = [&](std::size_t k, std::size_t c) {
                return calls_.rows[k][calls_.layouts[k].parts[i].at + c];
            };
            const std::string& name = parts[i].name;
            if (equals(argument)) return Form{fmt::format("is `{}` itself", name), 1.5};
            if (equals([&](std::size_t k, std::size_t c) { return -argument(k, c); }))
                return Form{fmt::format("is `-{}` itself", name), 1.6};
            if (equals([&](std::size_t k, std::size_t c) { return right(k, c) - argument(k, c); }))
                return Form{fmt::format("is as if `{}` were not added, or taken away", name), 2};
            if (equals([&](std::size_t k, std::size_t c) { return right(k, c) + argument(k, c); }))
                return Form{fmt::format("is as if `{}` were added, or not taken away", name), 2};
        }
        return std::nullopt;
    }

    /// Columns of logarithms, of quantities that a factor may hold.
    struct Column {
        std::string words;
        std::vector<double> log;
    };

    std::vector<Column> columns() const {
        std::vector<Column> list;
        const auto add = [&](const std::string& words, auto value) {
            std::vector<double> log;
            double least = rt::inf, most = -rt::inf;
            for (const std::size_t k : scope_) {
                log.push_back(value(k));
                least = std::min(least, log.back()), most = std::max(most, log.back());
            }
            if (std::isfinite(least) && std::isfinite(most) && most - least > 1e-3)
                list.push_back({words, std::move(log)});
        };
        const auto quantities = quantities_of(calls_.layouts.front(), calls_.told, &calls_.result);
        const auto at = [&](const Quantity& q, std::size_t k) {
            return q.value(calls_.rows[k], calls_.layouts[k], calls_.mine[k]);
        };
        for (const Quantity& q : quantities)
            if (q.words != "the answer's " + part_.name)
                add(q.words, [&](std::size_t k) { return std::log(std::abs(at(q, k))); });
        for (const Quantity& q : quantities) {
            const bool is_plain = q.words.find('|') == q.words.npos && q.words.find('(') == q.words.npos &&
                                  q.words.find('\'') == q.words.npos;
            if (!is_plain) continue;
            for (const int more : {1, 2, -1})
                add(fmt::format("({} {} {})", q.words, more > 0 ? "+" : "-", std::abs(more)),
                    [&](std::size_t k) { return std::log(std::abs(at(q, k) + more)); });
            add(fmt::format("sqrt(1 - {0} * {0})", q.words),
                [&](std::size_t k) { return std::log(1 - at(q, k) * at(q, k)) / 2; });
            for (const Quantity& base : quantities)
                if (base.words.starts_with("dot") || base.words.ends_with(".z"))
                    add(fmt::format("pow({}, {})", base.words, q.words),
                        [&](std::size_t k) { return at(q, k) * std::log(at(base, k)); });
        }
        return list;
    }

    /// The logarithm of mine over right in each call of the scope, the same in all components.
    std::optional<std::vector<double>> log_ratio() const {
        std::vector<double> log;
        for (const std::size_t k : scope_) {
            std::size_t most = 0;
            for (std::size_t c = 1; c < size_; ++c)
                if (std::abs(right(k, c)) > std::abs(right(k, most))) most = c;
            const double ratio = mine(k, most) / right(k, most);
            if (!(std::abs(ratio) > 0) || !std::isfinite(ratio)) return std::nullopt;
            for (std::size_t c = 0; c < size_; ++c)
                if (!is_close(mine(k, c), ratio * right(k, c), std::abs(mine(k, most)))) return std::nullopt;
            log.push_back(std::log(std::abs(ratio)));
        }
        return log;
    }

    static std::optional<double> nice_power(double p) {
        for (const double nice : {1.0, 2.0, 0.5, 3.0, 4.0, 1.5})
            if (std::abs(std::abs(p) - nice) < 1e-3) return std::copysign(nice, p);
        return std::nullopt;
    }

    static std::string power(const std::string& words, double p) {
        return p == 1 ? words : fmt::format("{}^{:g}", words, p);
    }

    static std::string times(double c, const std::string& words) {
        return std::abs(c - 1) < 1e-4 ? words : constant(c) + " * " + words;
    }

    /// Mine is a quantity, times a constant.
    std::optional<Form> of_quantity() const {
        if (size_ != 1 || part_.kind != Kind::number) return std::nullopt;
        std::vector<double> log;
        for (const std::size_t k : scope_) log.push_back(std::log(std::abs(mine(k, 0))));
        const auto all = columns();
        for (const Column& q : all)
            if (const auto fit = fitted(log, {&q}); fit && nice_power(fit->powers[0]))
                if (is_named(std::exp(fit->constant)))
                    return Form{fmt::format("is `{}`", times(std::exp(fit->constant),
                                                             power(q.words, *nice_power(fit->powers[0])))),
                                2.4};
        return std::nullopt;
    }

    struct Fit {
        double constant;
        std::array<double, 2> powers;
    };

    /// log = constant + powers . columns, exactly.
    static std::optional<Fit> fitted(const std::vector<double>& log, std::vector<const Column*> columns) {
        const std::size_t n = log.size(), m = columns.size();
        if (n < 5 + m) return std::nullopt;
        const auto mean = [n](const std::vector<double>& v) {
            double sum = 0;
            for (const double x : v) sum += x;
            return sum / double(n);
        };
        const double y = mean(log);
        if (!std::isfinite(y)) return std::nullopt;
        std::array<double, 2> x{};
        for (std::size_t a = 0; a < m; ++a) x[a] = mean(columns[a]->log);
        double xx = 0, xz = 0, zz = 0, xy = 0, zy = 0;
        for (std::size_t k = 0; k < n; ++k) {
            const double dx = columns[0]->log[k] - x[0], dz = m > 1 ? columns[1]->log[k] - x[1] : 0, dy = log[k] - y;
            xx += dx * dx, xz += dx * dz, zz += dz * dz, xy += dx * dy, zy += dz * dy;
        }
        Fit fit{0, {}};
        if (m == 1)
            fit.powers[0] = xy / xx;
        else {
            const double determinant = xx * zz - xz * xz;
            if (!(determinant > 1e-6 * xx * zz)) return std::nullopt;
            fit.powers = {(xy * zz - zy * xz) / determinant, (zy * xx - xy * xz) / determinant};
        }
        fit.constant = y - fit.powers[0] * x[0] - fit.powers[1] * x[1];
        for (std::size_t k = 0; k < n; ++k) {
            double value = fit.constant;
            for (std::size_t a = 0; a < m; ++a) value += fit.powers[a] * columns[a]->log[k];
            if (!(std::abs(value - log[k]) < equal_within)) return std::nullopt;
        }
        return fit;
    }

    std::optional<Form> product() const {
        const auto log = log_ratio();
        if (!log) return std::nullopt;
        const auto all = columns();
        const auto form = [](double c, const std::string& words, double cost) {
            return Form{fmt::format("is `{}` times what it must be", times(c, words)), cost};
        };
        for (const Column& q : all)
            if (const auto fit = fitted(*log, {&q}))
                if (const auto p = nice_power(fit->powers[0]))
                    return form(std::exp(fit->constant), power(q.words, *p), 2.5);
        for (std::size_t a = 0; a < all.size(); ++a)
            for (std::size_t b = a + 1; b < all.size(); ++b)
                if (const auto fit = fitted(*log, {&all[a], &all[b]})) {
                    const auto p = nice_power(fit->powers[0]), q = nice_power(fit->powers[1]);
                    if (p && q && is_named(std::exp(fit->constant)))
                        return form(std::exp(fit->constant), power(all[a].words, *p) + " * " + power(all[b].words, *q),
                                    3.5);
                }
        return std::nullopt;
    }

    const Calls& calls_;
    const Field& part_;
    const Rows& right_;
    const std::vector<std::size_t>& scope_;
    std::size_t size_;
};

}  // namespace

std::optional<Form> form_of(const Calls& calls, const Field& part, const Rows& right,
                            const std::vector<std::size_t>& scope, bool only_simple) {
    const Forms forms(calls, part, right, scope);
    return only_simple ? forms.simple() : forms.any();
}

}  // namespace grade
