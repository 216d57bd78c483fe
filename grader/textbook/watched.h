#pragma once

#include <algorithm>
#include <functional>
#include <span>
#include <type_traits>

#include "rt/math.h"

/// What each expression of a textbook's form goes through while it is computed, or of a student's source: there another
/// value can take its place, see watch.h. The grader puts this text into what it compiles.
namespace grade::textbook {

/// Which alternative stands there; 0: what is written.
int chosen(int node);

/// Throw std::runtime_error where a call takes too long.
double at(int node, double x);
float at(int node, float x);
int at(int node, int x);
std::size_t at(int node, std::size_t x);
bool at(int node, bool x);
rt::vec2 at(int node, rt::vec2 x);
rt::vec3 at(int node, rt::vec3 x);

/// What has no numbers of these kinds passes as it is.
template <class Other>
Other at(int, Other&& x) {
    return std::forward<Other>(x);
}

/// An element of a list; beyond its end, the last one, or a default. Of what has no such end, as it is written.
template <class Value, class Index>
Value element(std::span<const Value> list, Index i) {
    return list.empty() ? Value{} : list[std::min(std::size_t(i), list.size() - 1)];
}

template <class List, class Index>
decltype(auto) element(const List& list, Index i) {
    const auto within = [&](auto size) { return size > 0 ? std::clamp(i, Index(0), Index(size - 1)) : i; };
    if constexpr (std::is_integral_v<Index> && requires { std::size(list); })
        return list[within(std::size(list))];
    else if constexpr (std::is_integral_v<Index> && requires { List::length(); })
        return list[within(List::length())];
    else
        return list[i];
}

/// What `x.length()` is: of a vector the number of its components or, where that is chosen, its length.
template <class Object>
auto length_of(int node, const Object& x) {
    if constexpr (requires { Object::length(), glm::length(x); })
        return chosen(node) == 1 ? double(glm::length(x)) : double(Object::length());
    else
        return x.length();
}

/// Whole numbers are not divided by 0.
struct Quotient {
    template <class A, class B>
    auto operator()(const A& a, const B& b) const -> decltype(a / b) {
        if constexpr (std::is_integral_v<A> && std::is_integral_v<B>)
            if (b == 0) return a;
        return a / b;
    }
};

struct Rest {
    template <class A, class B>
    auto operator()(const A& a, const B& b) const -> decltype(a % b) {
        return b == 0 ? a : a % b;
    }
};

/// Of vectors, whose product is taken number by number.
struct Dot {
    rt::vec3 operator()(const rt::vec3& a, const rt::vec3& b) const { return rt::vec3(rt::dot(a, b)); }
};

template <class Operation>
struct Reversed {
    template <class A, class B>
    auto operator()(const A& a, const B& b) const -> decltype(Operation{}(b, a)) {
        return Operation{}(b, a);
    }
};

/// The result of Operation, or that of the chosen one of Others where it has the same type.
template <class Operation, class... Others, class A, class B>
auto binary(int node, const A& a, const B& b) {
    using Written = std::decay_t<decltype(Operation{}(a, b))>;
    Written result = Operation{}(a, b);
    int number = 0;
    [[maybe_unused]] const auto take = [&, choice = chosen(node)](auto other) {
        using Other = decltype(other);
        if constexpr (std::is_invocable_v<Other, const A&, const B&>)
            if constexpr (std::is_same_v<Written, std::decay_t<std::invoke_result_t<Other, const A&, const B&>>>)
                if (number + 1 == choice) result = other(a, b);
        ++number;
    };
    (take(Others{}), ...);
    return result;
}

/// As binary, where one side is a sum in brackets, first and second; with `number` chosen, the value where these are
/// forgotten: (a b) c for a (b c), or the other way round.
template <class Sum, bool are_last, class Operation, class... Others, class A, class B, class C, class D>
auto regrouped(int node, int number, const A& a, const B& b, const C& first, const D& second) {
    auto written = binary<Operation, Others...>(node, a, b);
    using Written = decltype(written);
    if (chosen(node) != number) return written;
    if constexpr (are_last) {
        if constexpr (std::is_invocable_v<Operation, const A&, const C&>)
            if constexpr (std::is_invocable_r_v<Written, Sum, std::invoke_result_t<Operation, const A&, const C&>,
                                                const D&>)
                written = Sum{}(Operation{}(a, first), second);
    } else {
        if constexpr (std::is_invocable_v<Operation, const D&, const B&>)
            if constexpr (std::is_invocable_r_v<Written, Sum, const C&,
                                                std::invoke_result_t<Operation, const D&, const B&>>)
                written = Sum{}(first, Operation{}(second, b));
    }
    return written;
}

}  // namespace grade::textbook
