#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "protocol/rows.h"
#include "rt/answers.h"

/// Functions with the arguments of fragments, called on rows of numbers.
namespace grade {

/// An argument read from a row, kept alive while the fragment runs on it.
template <class Argument>
struct Held {
    Argument value;

    explicit Held(RowReader& in) : value(read(in, Tag<Argument>{})) {}
    const Argument& get() { return value; }
    void use(Numbers&) const {}
};

/// What a function notes: how often it was asked, and between where.
constexpr std::size_t noted = 3;

/// A function that notes where it was asked.
template <>
struct Held<rt::Function> {
    Integrand f;
    double calls = 0, least = rt::inf, greatest = -rt::inf;

    explicit Held(RowReader& in) : f(read(in, Tag<Integrand>{})) {}
    rt::Function get() {
        return [this](double x) {
            ++calls;
            least = std::min(least, x);
            greatest = std::max(greatest, x);
            return f(x);
        };
    }
    void use(Numbers& out) const { out.insert(out.end(), {calls, least, greatest}); }
};

template <class Value>
struct Held<std::span<const Value>> {
    std::vector<Value> values;

    explicit Held(RowReader& in) : values(read(in, Tag<std::vector<Value>>{})) {}
    std::span<const Value> get() { return values; }
    void use(Numbers&) const {}
};

template <>
struct Held<std::span<const rt::Stratum>> {
    std::vector<StratumOf> owners;
    std::vector<rt::Stratum> strata;

    explicit Held(RowReader& in) : owners(read(in, Tag<std::vector<StratumOf>>{})) {
        for (const StratumOf& owner : owners) strata.push_back({owner.low, owner.high, owner.u});
    }
    std::span<const rt::Stratum> get() { return strata; }
    void use(Numbers&) const {}
};

template <class Result, class... Arguments>
Numbers call(Result (*fragment)(Arguments...), std::span<const double> row) {
    RowReader in(row);
    std::tuple<Held<std::decay_t<Arguments>>...> held{Held<std::decay_t<Arguments>>(in)...};
    if (!in.at_end()) throw std::domain_error("the row is too long");
    Numbers out;
    std::apply([&](auto&... argument) { append(out, fragment(argument.get()...)); }, held);
    std::apply([&](auto&... argument) { (argument.use(out), ...); }, held);
    return out;
}

using Caller = std::function<Numbers(std::span<const double>)>;

/// Throws what probe() of child/probes.h throws.
template <class Fragment>
Caller caller(Fragment* fragment) {
    return [fragment](std::span<const double> row) { return call(fragment, row); };
}

}  // namespace grade
