#include "diagnosis/terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/constants.h"
#include "diagnosis/scalars.h"

namespace grade {

namespace {

using rt::vec3;

/// A vector of the arguments, times numbers of them, in each call of the scope.
struct Term {
    std::string words;
    std::vector<vec3> value;
};

std::vector<Term> terms(const PartOfCalls& of) {
    const Calls& calls = of.calls;
    const auto& parts = calls.layouts.front().parts;
    const auto told = told_of(calls, of.scope);
    std::vector<Term> vectors, factors, all;  // of a factor, only x counts
    const auto add = [&](std::vector<Term>& list, const std::string& words, auto value) {
        Term term{words, {}};
        for (const std::size_t k : of.scope) term.value.push_back(value(k));
        list.push_back(std::move(term));
    };
    std::vector<std::size_t> of_vectors;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].kind == Kind::vector && told[i]) of_vectors.push_back(i);
    const auto at = [&](std::size_t k, std::size_t i) {
        return vector_at(calls.rows[k], calls.layouts[k].parts[i].at);
    };
    for (const std::size_t i : of_vectors) add(vectors, parts[i].name, [&](std::size_t k) { return at(k, i); });
    add(factors, "", [](std::size_t) { return vec3(1); });
    for (const Scalar& s : scalars_of(calls.layouts.front(), told))
        add(factors, s.name, [&](std::size_t k) { return vec3(calls.rows[k][s.at(calls.layouts[k])]); });
    for (std::size_t a = 0; a < of_vectors.size(); ++a)
        for (std::size_t b = a; b < of_vectors.size(); ++b)
            add(factors, fmt::format("dot({}, {})", parts[of_vectors[a]].name, parts[of_vectors[b]].name),
                [&](std::size_t k) { return vec3(rt::dot(at(k, of_vectors[a]), at(k, of_vectors[b]))); });
    for (const std::size_t i : of_vectors)
        add(factors, fmt::format("|{}|", parts[i].name), [&](std::size_t k) { return vec3(glm::length(at(k, i))); });
    add(vectors, "(1, 1, 1)", [](std::size_t) { return vec3(1); });
    for (const Term& factor : factors)
        for (const Term& vector : vectors) {
            Term term{factor.words.empty() ? vector.words : factor.words + " * " + vector.words, {}};
            for (std::size_t i = 0; i < vector.value.size(); ++i)
                term.value.push_back(factor.value[i].x * vector.value[i]);
            all.push_back(std::move(term));
        }
    constexpr std::size_t most = 80;
    if (all.size() > most) all.resize(most);
    return all;
}

/// Products of up to two numbers of the arguments.
std::vector<Term> terms_of_numbers(const PartOfCalls& of) {
    constexpr std::size_t most = 5;
    const Calls& calls = of.calls;
    const auto scalars = scalars_of(calls.layouts.front(), told_of(calls, of.scope));
    std::vector<Term> all;
    if (scalars.size() > most) return all;
    const auto add = [&](const std::string& words, auto value) {
        Term term{words, {}};
        for (const std::size_t k : of.scope) term.value.emplace_back(value(k), 0, 0);
        all.push_back(std::move(term));
    };
    const auto at = [&](std::size_t k, const Scalar& s) { return calls.rows[k][s.at(calls.layouts[k])]; };
    for (const Scalar& s : scalars) add(s.name, [&](std::size_t k) { return at(k, s); });
    for (std::size_t a = 0; a < scalars.size(); ++a)
        for (std::size_t b = a; b < scalars.size(); ++b)
            add(scalars[a].name + " * " + scalars[b].name,
                [&](std::size_t k) { return at(k, scalars[a]) * at(k, scalars[b]); });
    add("", [](std::size_t) { return 1.0; });
    return all;
}

/// Some terms, each with a factor.
struct Sum {
    std::vector<const Term*> terms;
    std::vector<double> factors;
};

double product(const std::vector<vec3>& v, const std::vector<vec3>& w) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += rt::dot(v[i], w[i]);
    return sum;
}

bool is_sum(const std::vector<vec3>& wanted, const Sum& sum) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        vec3 made(0);
        for (std::size_t a = 0; a < sum.terms.size(); ++a) made += sum.factors[a] * sum.terms[a]->value[i];
        const double scale = std::max({1e-9, std::abs(wanted[i].x), std::abs(wanted[i].y), std::abs(wanted[i].z)});
        for (int c = 0; c < 3; ++c)
            if (!is_close(wanted[i][c], made[c], scale)) return false;
    }
    return true;
}

/// What is wanted as a sum of these terms, by least squares; none: it is none.
std::optional<Sum> fitted(const std::vector<vec3>& wanted, std::vector<const Term*> terms) {
    const std::size_t n = terms.size();
    std::vector<std::vector<double>> rows(n);
    for (std::size_t a = 0; a < n; ++a) {
        for (const Term* other : terms) rows[a].push_back(product(terms[a]->value, other->value));
        rows[a].push_back(product(terms[a]->value, wanted));
    }
    for (std::size_t a = 0; a < n; ++a) {
        if (!(rows[a][a] > 1e-9 * product(terms[a]->value, terms[a]->value))) return std::nullopt;
        for (std::size_t b = 0; b < n; ++b) {
            if (a == b) continue;
            const double f = rows[b][a] / rows[a][a];
            for (std::size_t c = a; c <= n; ++c) rows[b][c] -= f * rows[a][c];
        }
    }
    Sum sum{std::move(terms), {}};
    for (std::size_t a = 0; a < n; ++a) sum.factors.push_back(rows[a][n] / rows[a][a]);
    return is_sum(wanted, sum) ? std::optional(std::move(sum)) : std::nullopt;
}

/// The first sum that is wanted in every call, of as few terms as possible.
std::optional<Sum> sum_of(const std::vector<vec3>& wanted, const std::vector<Term>& all) {
    constexpr std::size_t most_by_threes = 24;
    for (const Term& a : all)
        if (auto sum = fitted(wanted, {&a})) return sum;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            if (auto sum = fitted(wanted, {&all[i], &all[j]})) return sum;
    for (std::size_t i = 0; i < all.size() && all.size() <= most_by_threes; ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j)
            for (std::size_t k = j + 1; k < all.size(); ++k)
                if (auto sum = fitted(wanted, {&all[i], &all[j], &all[k]})) return sum;
    return std::nullopt;
}

std::string in_words(const Sum& sum) {
    const auto times = [](double x, const std::string& words) {
        if (words.empty()) return constant(x);
        return std::abs(x - 1) < 1e-4 ? words : constant(x) + " * " + words;
    };
    std::string text;
    for (std::size_t a = 0; a < sum.terms.size(); ++a) {
        const double x = sum.factors[a];
        const std::string one = times(std::abs(x), sum.terms[a]->words);
        text += (x < 0 ? text.empty() ? "-" : " - " : text.empty() ? "" : " + ") + one;
    }
    return text;
}

bool is_plain(const Sum& sum) { return std::ranges::all_of(sum.factors, is_named); }

/// As vectors, of a number as x.
template <class Value>
std::vector<vec3> values(const PartOfCalls& of, Value value) {
    std::vector<vec3> all(of.scope.size(), vec3(0));
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t c = 0; c < of.size(); ++c) all[i][int(c)] = value(of.scope[i], c);
    return all;
}

}  // namespace

std::optional<AnswerForm> terms_of(const PartOfCalls& of) {
    constexpr std::size_t enough = 8;
    const bool is_number = of.part.kind == Kind::number;
    if ((of.part.kind != Kind::vector && !is_number) || of.scope.size() < enough) return std::nullopt;
    const auto mine = values(of, [&](std::size_t k, std::size_t c) { return of.mine(k, c); }),
               right = values(of, [&](std::size_t k, std::size_t c) { return of.right(k, c); });
    for (const vec3& v : mine)
        if (!std::isfinite(v.x + v.y + v.z)) return std::nullopt;
    const std::vector<Term> all = is_number ? terms_of_numbers(of) : terms(of);
    const auto own = sum_of(mine, all);
    if (!own || !is_plain(*own)) return std::nullopt;
    const auto due = sum_of(right, all);
    const bool is_due = due && is_plain(*due);
    if (is_number && !is_due) return std::nullopt;
    return AnswerForm{
        fmt::format("is `{}`{}", in_words(*own), is_due ? fmt::format(", must be `{}`", in_words(*due)) : ""),
        own->terms.size() > 1 ? 1.6 : 1.5};
}

std::string small_offsets(const Calls& calls) {
    constexpr double rounding = 1e-8;
    std::string words;
    for (const Field& part : calls.result.parts) {
        if (part.kind != Kind::vector && part.kind != Kind::number) continue;
        std::vector<std::size_t> scope;
        bool is_off = false;
        for (std::size_t k = 0; k < calls.size(); ++k) {
            if (std::isfinite(calls.right[k][part.at])) scope.push_back(k);
            is_off = is_off || !is_equal(part, calls.mine[k], calls.right[k], rounding);
        }
        const PartOfCalls of{calls, part, calls.right, scope};
        const auto sum =
            !is_off ? std::nullopt
                    : sum_of(values(of, [&](std::size_t k, std::size_t c) { return of.mine(k, c) - of.right(k, c); }),
                             part.kind == Kind::number ? terms_of_numbers(of) : terms(of));
        if (!sum || sum->terms.size() > 1) continue;
        words += fmt::format("{}{} is off by `{}`", words.empty() ? "" : ", and ",
                             part.name.empty() ? "the answer" : "`" + part.name + "`", in_words(*sum));
    }
    return words;
}

}  // namespace grade
