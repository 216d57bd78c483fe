#pragma once

#include <tuple>
#include <type_traits>

#include "checks/kit/check.h"
#include "protocol/rows.h"

/// Fragments that are formulas: each row of outputs has one right value.
namespace grade {

using RowFunction = std::function<Row(const Row& inputs)>;

/// A function of a fragment's arguments as a function of rows: of<rt::vec3, rt::vec3>([](rt::vec3 d, rt::vec3 n)
/// {...}).
template <class... Arguments, class F>
RowFunction of(F f) {
    return [f](const Row& inputs) {
        RowReader in(inputs);
        const std::tuple<Arguments...> arguments{read(in, Tag<Arguments>{})...};
        auto result = std::apply(f, arguments);
        if constexpr (std::is_same_v<decltype(result), Row>) return result;  // numbers already
        else return row(result);
    };
}

/// One argument of a row: argument<2, rt::Emitter, rt::vec3, rt::vec2>(row) is u.
template <std::size_t index, class... Arguments>
auto argument(const Row& inputs) {
    RowReader in(inputs);
    const std::tuple<Arguments...> arguments{read(in, Tag<Arguments>{})...};
    return std::get<index>(arguments);
}

/// How far two rows are apart, relative to the larger of 1e-3 and the largest number of the right one; nan or inf where
/// a number is not finite and the right one is another. Numbers beyond those of the right one do not count.
double deviation(const Row& outputs, const Row& right);

/// A mistake that is known to be made, as the outputs to which it leads.
struct Suspect {
    std::string words;  // "the far root is returned; expected the near one"
    RowFunction outputs;
};

/// A mistake that shows as the arguments for which the outputs are wrong.
struct Circumstance {
    std::string words;  // "t is a length where |direction| is not 1"
    std::function<bool(const Row& inputs)> holds;
};

/// The largest deviation of any row, which must stay below the tolerance. Single precision reaches 1e-4 where the
/// inputs are ordinary. The cause is the first suspect whose outputs are those of the rows; else the first circumstance
/// that nearly all wrong rows have in common, and other rows have not; the worst row is shown as well.
Statistic formula(std::string id, std::string what, RowFunction right, double tolerance,
                  std::vector<Suspect> suspects = {}, std::vector<Circumstance> circumstances = {});

/// The largest of a deviation of each row: 0 where a property holds.
Statistic property(std::string id, std::string what,
                   std::function<double(const Row& inputs, const Row& outputs)> violation, double tolerance,
                   std::string hint);

/// Rows that are repeated at the end: the same arguments must give the same outputs. repeat() appends them.
Statistic purity();
Rows repeat(Rows rows);

}  // namespace grade
