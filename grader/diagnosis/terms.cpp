#include "diagnosis/terms.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
    std::vector<Term> vectors, factors, all;  // of a factor, only x counts
    const auto add = [&](std::vector<Term>& list, const std::string& words, auto value) {
        Term term{words, {}};
        for (const std::size_t k : of.scope) term.value.push_back(value(k));
        list.push_back(std::move(term));
    };
    std::vector<std::size_t> of_vectors;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].kind == Kind::vector && (i >= calls.told.size() || calls.told[i])) of_vectors.push_back(i);
    const auto at = [&](std::size_t k, std::size_t i) {
        return vector_at(calls.rows[k], calls.layouts[k].parts[i].at);
    };
    for (const std::size_t i : of_vectors) add(vectors, parts[i].name, [&](std::size_t k) { return at(k, i); });
    add(factors, "", [](std::size_t) { return vec3(1); });
    for (const Scalar& s : scalars_of(calls.layouts.front(), calls.told))
        add(factors, s.name, [&](std::size_t k) { return vec3(calls.rows[k][s.at(calls.layouts[k])]); });
    for (std::size_t a = 0; a < of_vectors.size(); ++a)
        for (std::size_t b = a; b < of_vectors.size(); ++b)
            add(factors, fmt::format("dot({}, {})", parts[of_vectors[a]].name, parts[of_vectors[b]].name),
                [&](std::size_t k) { return vec3(rt::dot(at(k, of_vectors[a]), at(k, of_vectors[b]))); });
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

struct Sum {
    const Term *a = nullptr, *b = nullptr;
    double x = 0, y = 0;  // their factors
};

double product(const std::vector<vec3>& v, const std::vector<vec3>& w) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += rt::dot(v[i], w[i]);
    return sum;
}

bool is_sum(const std::vector<vec3>& wanted, const Sum& sum) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        const vec3 made = sum.x * sum.a->value[i] + (sum.b ? sum.y * sum.b->value[i] : vec3(0));
        const double scale = std::max({1e-9, std::abs(wanted[i].x), std::abs(wanted[i].y), std::abs(wanted[i].z)});
        for (int c = 0; c < 3; ++c)
            if (!is_close(wanted[i][c], made[c], scale)) return false;
    }
    return true;
}

/// The first sum that is wanted in every call, of as few terms as possible.
std::optional<Sum> sum_of(const std::vector<vec3>& wanted, const std::vector<Term>& all) {
    const double most = product(wanted, wanted);
    std::vector<double> square, with;
    for (const Term& t : all) square.push_back(product(t.value, t.value)), with.push_back(product(t.value, wanted));
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const Sum sum{&all[i], nullptr, with[i] / square[i], 0}; square[i] > 0 && is_sum(wanted, sum)) return sum;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            const double both = product(all[i].value, all[j].value), d = square[i] * square[j] - both * both;
            if (!(d > 1e-6 * square[i] * square[j])) continue;
            const Sum sum{&all[i], &all[j], (with[i] * square[j] - with[j] * both) / d,
                          (with[j] * square[i] - with[i] * both) / d};
            const double left = most - sum.x * with[i] - sum.y * with[j];
            if (left <= 1e-6 * most && is_sum(wanted, sum)) return sum;
        }
    return std::nullopt;
}

std::string in_words(const Sum& sum) {
    const auto one = [](double x, const std::string& words) {
        return std::abs(x - 1) < 1e-4 ? words : constant(x) + " * " + words;
    };
    std::string text = std::abs(sum.x + 1) < 1e-4 ? "-" + sum.a->words : one(sum.x, sum.a->words);
    if (sum.b) text += (sum.y < 0 ? " - " : " + ") + one(std::abs(sum.y), sum.b->words);
    return text;
}

bool is_plain(const Sum& sum) { return is_named(sum.x) && (!sum.b || is_named(sum.y)); }

}  // namespace

std::optional<Form> terms_of(const PartOfCalls& of) {
    constexpr std::size_t enough = 8;
    if (of.part.kind != Kind::vector || of.scope.size() < enough) return std::nullopt;
    std::vector<vec3> mine, right;
    for (const std::size_t k : of.scope) {
        mine.emplace_back(of.mine(k, 0), of.mine(k, 1), of.mine(k, 2));
        right.emplace_back(of.right(k, 0), of.right(k, 1), of.right(k, 2));
        if (!std::isfinite(mine.back().x + mine.back().y + mine.back().z)) return std::nullopt;
    }
    const std::vector<Term> all = terms(of);
    const auto own = sum_of(mine, all);
    if (!own || !is_plain(*own)) return std::nullopt;
    const auto due = sum_of(right, all);
    return Form{fmt::format("is `{}`{}", in_words(*own),
                            due && is_plain(*due) ? fmt::format(", must be `{}`", in_words(*due)) : ""),
                own->b ? 2.0 : 1.7};
}

}  // namespace grade
