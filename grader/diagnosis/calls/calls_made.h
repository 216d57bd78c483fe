#pragma once

#include "diagnosis/calls/calls.h"

/// Calls that are asked for, and what they show without a relation.
namespace grade {

constexpr std::size_t most_calls = 250'000;  // that the solution is asked for

/// The answers to as many rows as are left; where any is missing, none.
Ask limited(const Ask& ask, std::size_t& left);

constexpr std::size_t most_compared = 80;  // calls among which a relation is looked for

/// The calls that are wrong.
Calls only_wrong(const Calls& all);

/// The calls, of which only those count as wrong whose answer is no number.
Calls only_nan(Calls calls);

/// Calls of which `most` are picked evenly, as many wrong as right ones where there are; others in between.
Calls picked(const Calls& all, std::size_t most, bool others = false);

/// Calls whose numbers can be compared.
Calls compared(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right);

/// Calls with one number more from another call: what the checks' calls have in common by their making, a relation must
/// not rest on.
Calls crossed(const Calls& calls, const Ask& mine, const Ask& right);

/// Of a ray and a shape, the calls and those of rays that start near the shape, whose interval is all numbers: where a
/// mistake lets every usual ray miss, some of these hit. Of other arguments, the calls alone.
Calls near_shapes(const Calls& calls, const Ask& mine, const Ask& right);

/// The arguments of some calls, `most` at most, one after the other, each with random numbers from all over the square,
/// or from the whole interval, in place of its own: side * side of them.
///
/// u  which part of the arguments the numbers are
Rows over_the_square(const Calls& calls, std::size_t u, std::size_t most, std::size_t side);

/// In what share of the calls an answer changes with a part.
struct Dependence {
    double mine = 0, right = 0;
};

/// On which parts the answers to these calls depend: each is taken from one of `others`.
std::vector<Dependence> dependences(const Calls& asked, const Calls& others, const Ask& mine, const Ask& right);

/// What the answers do not depend on though they must, or the other way round.
std::string independence(const Calls& calls, const std::vector<Dependence>& all);

/// That random numbers are not used at all; empty: they are.
std::string unused_numbers(const Calls& calls, const std::vector<Dependence>& all);

/// One answer that nearly all wrong calls get, as of a mistake by which nothing is hit.
std::string usual_wrong_answer(const Calls& calls);

/// The calls, of which only those parts are told that an answer to a wrong call depends on.
Calls with_parts_that_matter(Calls all, const Ask& mine, const Ask& right);

}  // namespace grade
