#pragma once

#include "diagnosis/calls/calls.h"

namespace grade {

/// Some of all calls: "where `dot(n, to_light) < 0`".
struct WrongCalls {
    std::string words;  // empty: all of them
    std::function<bool(const Row& row, const Layout& layout, const Row& right)> holds;
    bool is_exact = false;               // it holds for all wrong calls, and for no other
    bool of_answers = false;             // right answers set them apart, first of all
    std::string not_unit{};              // the vector whose length sets them apart, since it is not 1
    std::vector<std::string> numbers{};  // "c" of "`c < 0`"
    bool is_of_axis = false;             // in them a direction is along an axis of the world
};

/// What sets wrong calls apart from right ones; empty where nothing does.
///
/// of_answers  what the right answers are may set them apart as well, not the arguments alone
WrongCalls where_wrong(const Calls& calls, bool of_answers = true);

/// Of a choice and a flag, what is answered and what must be: "where `previous` is lobe, the answer is `!sampled`; it
/// must be true". Empty for other arguments.
std::string wrong_answers(const Calls& calls);

}  // namespace grade
