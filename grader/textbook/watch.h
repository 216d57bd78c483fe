#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>
#include <type_traits>
#include <vector>

#include "rt/math.h"

/// What each expression of a textbook's form goes through while it is computed.
namespace grade::textbook {

/// A value that was seen.
struct Value {
    enum class Kind { none, number, whole, flag, pair, vector };
    Kind kind = Kind::none;
    double x[3]{};
};

/// A mistake in an expression, or in several alike: another of its operators or functions, or another value.
struct Mistake {
    std::vector<int> nodes;
    int alternative = 0;                    // 0: none
    std::function<void(double* x)> make{};  // of a value's numbers; none: they stay

    bool is_of(int node) const { return std::ranges::find(nodes, node) != nodes.end(); }
};

/// Of the thread's present call.
struct Watch {
    int first = 0;              // the form's first node
    std::vector<Value> values;  // of its nodes, the latest
    const Mistake* mistakes[2]{};
    std::size_t passed = 0;  // values so far: a mistake may make a loop that does not end
};
extern thread_local Watch watch;

/// Which alternative stands there; 0: what is written.
inline int chosen(int node) {
    for (const Mistake* mistake : watch.mistakes)
        if (mistake && mistake->alternative != 0 && mistake->is_of(node)) return mistake->alternative;
    return 0;
}

/// Throw std::runtime_error where a call takes too long.
double at(int node, double x);
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

/// An element of a list; beyond its end, the last one, or a default.
template <class Value>
Value element(std::span<const Value> list, std::size_t i) {
    return list.empty() ? Value{} : list[std::min(i, list.size() - 1)];
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

/// `written`, or the value where brackets are forgotten: (a b) c for a (b c), or the other way round.
template <class Sum, class Product, bool are_last, class Written, class A, class B, class C>
Written regrouped(int node, int number, Written written, const A& a, const B& b, const C& c) {
    if (chosen(node) != number) return written;
    const auto take = [&](auto first, auto second, const auto& x, const auto& y, const auto& z) {
        using First = decltype(first);
        using Second = decltype(second);
        if constexpr (are_last) {
            if constexpr (std::is_invocable_v<Second, decltype(x), decltype(y)>)
                if constexpr (std::is_invocable_r_v<Written, First, decltype(second(x, y)), decltype(z)>)
                    written = first(second(x, y), z);
        } else {
            if constexpr (std::is_invocable_v<Second, decltype(y), decltype(z)>)
                if constexpr (std::is_invocable_r_v<Written, First, decltype(x), decltype(second(y, z))>)
                    written = first(x, second(y, z));
        }
    };
    take(Sum{}, Product{}, a, b, c);
    return written;
}

}  // namespace grade::textbook
