#pragma once

#include "diagnosis/changes/relation.h"
#include "textbook/edits.h"
#include "textbook/source.h"

/// What would have to stand in a student's own source.
namespace grade {

/// A fragment whose expressions can be changed while it runs.
struct Editable {
    std::vector<textbook::Node> nodes;
    std::set<std::string> varying;  // arguments among them that get other values: what was passed is not what is there
    Ask ask;                        // answers to calls as textbook::row_of makes them
    std::function<Calls()> further{};  // in which a change must hold as well before it is told; none: there are none
};

/// A change of one expression, or of two, after which the fragment gives the right answers.
struct Repair {
    std::string words;       // "with `a * b` in place of `a + b` in line 12, every answer is right"
    int line = 0;            // of the first change
    double share = 1;        // of the wrong calls that it puts right
    bool is_simple = false;  // of one expression, and simpler than two mistakes that explain as much
    bool is_of_two = false;
    bool is_of_literal = false;  // a number in the place of another
    bool is_borrowed = false;    // a textbook's expression in the place of one
    double cost = 0;
};

/// The simplest one; none: there is none. It breaks no right answer, of further calls neither.
///
/// only_one  of one expression, after which every answer is right
std::optional<Repair> repair_of(const Calls& calls, const Editable& source, bool only_one);

/// The simplest change of one expression after which samples are spread as they must be, wherever each of them lies;
/// none: there is none, or they are so.
std::optional<Repair> repair_of_spread(const Calls& calls, const Editable& source, const Ask& right);

/// What answers do not depend on though they must: random numbers; else other arguments, which a simple change of the
/// source says as well.
struct Unused {
    std::string numbers, others;
};

/// Where in the fragment's own source the mistake is, and where no relation says all, what it is.
void add_repair(std::optional<Relation>& relation, const Calls& calls, const std::optional<Editable>& source,
                const Unused& unused);

}  // namespace grade
