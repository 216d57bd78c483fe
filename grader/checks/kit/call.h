#pragma once

#include <span>
#include <tuple>
#include <type_traits>

#include "checks/kit/check.h"
#include "protocol/rows.h"

/// The arguments and the result of a fragment in the types of its declaration, out of the rows of a probe. The fragment
/// is named, never called: the grader is not linked with it.
namespace grade {

using RowFunction = std::function<Row(const Row& inputs)>;

/// A parameter as a row holds it: lists and functions own their numbers.
template <class Parameter>
struct Owned {
    using Type = Parameter;
};
template <>
struct Owned<rt::Function> {
    using Type = Integrand;
};
template <class Value>
struct Owned<std::span<const Value>> {
    using Type = std::vector<Value>;
};
template <>
struct Owned<std::span<const rt::Stratum>> {
    using Type = std::vector<StratumOf>;
};

template <class Fragment>
struct TypesOf;
template <class Value, class... Parameters>
struct TypesOf<Value (*)(Parameters...)> {
    using Result = Value;
    using Arguments = std::tuple<typename Owned<std::decay_t<Parameters>>::Type...>;

    template <class Returned>
    using Function = std::function<Returned(const typename Owned<std::decay_t<Parameters>>::Type&...)>;

    static Arguments arguments(const Row& inputs) {
        RowReader in(inputs);
        return Arguments{read(in, Tag<typename Owned<std::decay_t<Parameters>>::Type>{})...};
    }
};

/// What the fragment returned: result<rt::camera_ray>(outputs) is a Ray.
template <auto fragment>
auto result(const Row& outputs) {
    return from_row<typename TypesOf<decltype(fragment)>::Result>(outputs);
}

/// f(result) of each row, for a result that several fragments have.
template <class Result, class F>
auto of_result(F f) {
    return [f](const Row&, const Row& outputs) { return f(from_row<Result>(outputs)); };
}

/// One argument: argument<rt::light_sample, 2>(inputs) is u.
template <auto fragment, std::size_t index>
auto argument(const Row& inputs) {
    return std::get<index>(TypesOf<decltype(fragment)>::arguments(inputs));
}

/// f(arguments...) of each row of inputs.
template <auto fragment, class F>
auto of_arguments(F f) {
    return [f](const Row& inputs) { return std::apply(f, TypesOf<decltype(fragment)>::arguments(inputs)); };
}

/// f(result) or f(result, arguments...) of each row of inputs and outputs.
template <auto fragment, class F>
auto of_call(F f) {
    return [f](const Row& inputs, const Row& outputs) {
        const auto value = result<fragment>(outputs);
        if constexpr (std::is_invocable_v<F, decltype(value)>)
            return f(value);
        else
            return std::apply(f, std::tuple_cat(std::tuple(value), TypesOf<decltype(fragment)>::arguments(inputs)));
    };
}

/// f(arguments...) as outputs.
template <auto fragment, class F>
RowFunction answer(F f) {
    return [f](const Row& inputs) { return row(of_arguments<fragment>(f)(inputs)); };
}

}  // namespace grade
