#pragma once

#include "checks/kit/call.h"

/// Fragments that are formulas: each row of outputs has one right value.
namespace grade {

/// How far two rows are apart, relative to the larger of 1e-3, the largest number of the right one and the number that
/// is off: at most 2, so that 1 in place of 0 is off by 1. nan or inf where a number is not finite and the right one is
/// another. Numbers beyond those of the right one do not count.
double deviation(const Row& outputs, const Row& right);

/// A mistake that is known to be made, as the outputs to which it leads.
struct RowSuspect {
    std::string words;  // "the far root is returned; expected the near one"
    std::function<Row(const Row& inputs, const Row& right)> outputs;
};

/// A mistake that shows as the arguments for which the outputs are wrong.
struct RowCircumstance {
    std::string words;  // "t is a length where |direction| is not 1"
    std::function<bool(const Row& inputs)> holds;
};

struct RowFormula {
    std::string id, what;
    double tolerance = 0;
    RowFunction right;
    std::vector<RowSuspect> suspects;
    std::vector<RowCircumstance> circumstances;
};

/// The largest deviation of any row, which must stay below the tolerance; without one, how many rows are wrong. Single
/// precision reaches 1e-4 where the inputs are ordinary. The cause is the suspect whose outputs are those of most
/// rows, of nearly all; else the first circumstance that nearly all wrong rows have in common, and other rows have not;
/// the worst row is shown as well.
Statistic formula(const RowFormula& of_rows);

/// What a mistake returns: f(arguments...), or a change of the right answer, f(right) or f(right, arguments...).
template <auto fragment>
struct Instead {
    std::function<Row(const Row& inputs, const Row& right)> outputs;

    template <class F>
    Instead(F f) : outputs(from(f)) {}

private:
    template <class F, class Arguments>
    struct Takes;
    template <class F, class... A>
    struct Takes<F, std::tuple<A...>> : std::is_invocable<F, const A&...> {};

    template <class F>
    static auto from(F f) {
        return [f](const Row& inputs, const Row& right) {
            const auto arguments = TypesOf<decltype(fragment)>::arguments(inputs);
            if constexpr (Takes<F, std::remove_const_t<decltype(arguments)>>::value)
                return row(std::apply(f, arguments));
            else
                return row(of_call<fragment>(f)(inputs, right));
        };
    }
};

template <auto fragment>
struct Suspect {
    std::string words;
    Instead<fragment> answer;
};

template <auto fragment>
struct Circumstance {
    std::string words;
    typename TypesOf<decltype(fragment)>::template Function<bool> holds;
};

/// The formula of one fragment, in the types of its declaration.
template <auto fragment>
struct Formula {
    std::string id, what;
    double tolerance = 0;
    typename TypesOf<decltype(fragment)>::template Function<typename TypesOf<decltype(fragment)>::Result> right;
    std::vector<Suspect<fragment>> suspects;
    std::vector<Circumstance<fragment>> circumstances;
};

template <auto fragment>
Statistic formula(const Formula<fragment>& f) {
    RowFormula of_rows{f.id, f.what, f.tolerance, answer<fragment>(f.right), {}, {}};
    for (const Suspect<fragment>& suspect : f.suspects)
        of_rows.suspects.push_back({suspect.words, suspect.answer.outputs});
    for (const Circumstance<fragment>& circumstance : f.circumstances)
        of_rows.circumstances.push_back({circumstance.words, of_arguments<fragment>(circumstance.holds)});
    return formula(of_rows);
}

/// A number of each row, of inputs and outputs.
using RowNumber = std::function<double(const Row& inputs, const Row& outputs)>;

/// What must hold in each row: the violation, 0 where it does, may not exceed the tolerance in any.
struct Property {
    std::string id, what;
    RowNumber violation;
    double tolerance = 0;
    std::string says;
    std::vector<std::pair<std::string, RowNumber>> mistakes{};  // violations of what a mistake has in its place
};

/// The largest violation. The cause is the first mistake of which no row violates what it has, by the same tolerance.
Statistic property(const Property& property);

/// The direction that a fragment returns, alone or in a sample, must have length 1.
template <auto fragment>
Statistic unit_direction(const std::string& id, double tolerance = 1e-4) {
    return property(
        {.id = id,
         .what = "length of the direction, off 1 by",
         .violation = of_call<fragment>([](const auto& sample) { return std::abs(glm::length(sample.direction) - 1); }),
         .tolerance = tolerance,
         .says = "the direction is no unit vector"});
}

/// A camera's ray is valid from 0 to infinity.
template <auto fragment>
Statistic whole_ray(const std::string& id) {
    return property({.id = id,
                     .what = "the ray's interval",
                     .violation = of_call<fragment>([](const rt::Ray& ray) {
                         return ray.near >= 0 && ray.near < 1e-6 && ray.far > 1e6 ? 0.0 : 1.0;
                     }),
                     .says = "the ray must be valid from 0 to infinity"});
}

/// The same arguments must give the same outputs: of rows that with_repeats() appends again at the end.
Statistic purity();
std::function<Rows(Generator&)> with_repeats(std::function<Rows(Generator&)> inputs);

}  // namespace grade
