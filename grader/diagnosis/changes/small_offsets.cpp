#include "diagnosis/changes/small_offsets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/calls/scalars.h"
#include "diagnosis/changes/constants.h"

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

double product(const std::vector<vec3>& v, const std::vector<vec3>& w) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += rt::dot(v[i], w[i]);
    return sum;
}

/// "0.001 * n", of the first term that is wanted in every call, times a constant; empty: there is none.
std::string multiple_in_words(const std::vector<vec3>& wanted, const std::vector<Term>& all) {
    for (const Term& term : all) {
        const double factor = product(term.value, wanted) / product(term.value, term.value);
        bool is_so = std::isfinite(factor);
        for (std::size_t i = 0; is_so && i < wanted.size(); ++i) {
            const double scale = std::max(1e-9, rt::largest(wanted[i]));
            for (int c = 0; c < 3; ++c) is_so = is_so && is_close(wanted[i][c], factor * term.value[i][c], scale);
        }
        if (!is_so) continue;
        const std::string size = constant(std::abs(factor));
        const bool is_one = std::abs(std::abs(factor) - 1) < 1e-4;
        return (factor < 0 ? "-" : "") + (term.words.empty() ? size : is_one ? term.words : size + " * " + term.words);
    }
    return {};
}

/// As vectors, of a number as x.
template <class Value>
std::vector<vec3> values(const PartOfCalls& of, Value value) {
    std::vector<vec3> all(of.scope.size(), vec3(0));
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t c = 0; c < of.size(); ++c) all[i][int(c)] = value(of.scope[i], c);
    return all;
}

}  // namespace

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
        if (!is_off) continue;
        const auto off = [&](std::size_t k, std::size_t c) { return of.mine(k, c) - of.right(k, c); };
        const std::string by =
            multiple_in_words(values(of, off), part.kind == Kind::number ? terms_of_numbers(of) : terms(of));
        if (!by.empty()) words += fmt::format("{}{} is off by `{}`", words.empty() ? "" : ", and ", name_of(part), by);
    }
    return words;
}

}  // namespace grade
