#pragma once

#include "diagnosis/calls/calls.h"
#include "textbook/form.h"

namespace grade {

/// What wrong answers have to do with right ones, in every call that was looked at.
struct Relation {
    enum class Kind {
        sentence,
        change,         // the answers are the right fragment's with a change of an argument or of an expression
        named_mistake,  // and with a mistake that has a name
        of_kinds        // a sentence on calls of each kind, some of which are a change's
    };
    std::string said;  // of a change, what it is: "`u.x` in place of `u.y`"
    Kind kind = Kind::sentence;
    std::string calls{};     // of which it is said: "in the wrong calls "; empty: of all
    std::string edit{};      // of a change of an expression: what it is, without where
    std::string usually{};   // what that is in most code
    bool everywhere = true;  // else in those calls only that are wrong
    double cost = 0;

    /// What is explained: all, some of the calls or parts of the answer, or nothing beyond which parts are wrong. No
    /// mistake: the answers are right, for other random numbers that are as good.
    enum class Explains { all, some, nothing, no_mistake };
    Explains explains = Explains::all;
    bool other_numbers = false;  // the answers are the right fragment's for other random numbers
    bool is_elsewhere = false;   // so are its places, which are as good, and more is wrong with the rest
    const textbook::Form* other_form = nullptr;  // that is right, and whose samples lie elsewhere than the solution's
    bool has_other_order = false;                // samples come in another order, which is as good: of a named mistake
    double share = 1;                            // of what is wrong that is explained
    // explained exactly by a change of arguments, of a textbook's expression; put right by one of the fragment's own
    bool by_arguments = false, by_textbook = false, by_repair = false;
    bool of_two = false;                  // of two mistakes at once
    bool is_constant = false;             // a part of the answer is always the same, which says nothing of a cause
    bool only_where_not_nothing = false;  // it is looked for where the right answer is not 0 or inf alone
    bool others_remain = false;           // in which something else is wrong
    Rows others{};                        // of the calls that were looked at, those that are not explained
    std::string in_others{};              // what is wrong in these, or where the right answer is 0 or inf
    int line = 0;                         // of the fragment's own source, where the change is; 0: unknown
    int line_of_repair = 0;               // likewise, of one change that makes all answers right
    std::string repair{};                 // what would have to stand there
    double cost_of_repair = 0;
    bool is_borrowed = false;  // it is a textbook's expression

    bool has_change() const { return kind != Kind::sentence; }
    /// Whether the answers to all calls are the right fragment's with a change.
    bool is_change() const { return calls.empty() && (kind == Kind::change || kind == Kind::named_mistake); }

    /// What is found, in words.
    std::string words() const;
    /// And what that usually is, what is wrong in other calls, and where in the source.
    std::string all_words() const;
};

/// Whether a relation explains every call.
inline bool is_exact(const std::optional<Relation>& found) {
    return found && found->explains == Relation::Explains::all;
}

inline bool is_no_mistake(const std::optional<Relation>& found) {
    return found && found->explains == Relation::Explains::no_mistake;
}

Relation no_mistake();

/// The simplest one; none: none was found.
///
/// right    the solution
/// sampled  other random numbers give as good an answer
std::optional<Relation> relation_of(const Calls& calls, const Ask& right, bool sampled);

/// What `of_some` finds in calls of one kind each: of a disc, say. None: it finds nothing in any.
std::optional<Relation> by_kinds(const Calls& calls,
                                 const std::function<std::optional<Relation>(const Calls&)>& of_some);

}  // namespace grade
