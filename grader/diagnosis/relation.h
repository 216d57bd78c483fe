#pragma once

#include <string_view>

#include "diagnosis/calls.h"

namespace grade {

/// How the words of a change begin.
constexpr std::string_view as_changed = "the answers are exactly what the right fragment answers with ";

/// How the words of a relation that does not explain all calls end.
constexpr std::string_view other_mistakes = "; in the others something else is wrong";

/// How the words of one begin that is looked for where it is clearest.
constexpr std::string_view where_not_nothing = "where the right answer is not 0 or inf, ";

/// What wrong answers have to do with right ones, in every call that was looked at.
struct Relation {
    std::string words;
    std::string usually{};   // what that is in most code
    bool everywhere = true;  // else in those calls only that are wrong
    double cost = 0;

    /// What is explained: all, some of the calls or parts of the answer, or nothing beyond which parts are wrong.
    enum class Explains { all, some, nothing };
    Explains explains = Explains::all;
    bool other_numbers = false;  // the answers are the right fragment's for other random numbers
    double share = 1;            // of what is wrong that is explained
    // explained exactly by a change of arguments, of a textbook's expression; put right by one of the fragment's own
    bool by_arguments = false, by_textbook = false, by_repair = false;
    Rows others{};  // of the calls that were looked at, those that are not explained
};

/// The simplest one; none: none was found.
///
/// right    the solution
/// sampled  other random numbers give as good an answer; right_otherwise: these do, and nothing is wrong in these calls
std::optional<Relation> relation_of(const Calls& calls, const Ask& right, bool sampled, bool& right_otherwise);

/// What `of_some` finds in calls of one kind each: of a disc, say. None: it finds nothing in any.
std::optional<Relation> by_kinds(const Calls& calls,
                                 const std::function<std::optional<Relation>(const Calls&)>& of_some);

}  // namespace grade
