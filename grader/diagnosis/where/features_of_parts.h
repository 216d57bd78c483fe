#pragma once

#include "diagnosis/calls/calls.h"
#include "diagnosis/calls/directions.h"
#include "diagnosis/where/where.h"

namespace grade {

/// What may hold in a call, and set wrong ones apart.
struct Feature {
    using Test = std::function<bool(const Row& row, const Layout& layout, const Row& right)>;

    std::string words;
    Test test;
    bool of_answers = false;
    std::string number{};    // as WrongCalls has it
    std::string not_unit{};  // likewise
    bool is_of_axis = false;
    std::vector<bool> holds{};  // by call
};

/// Of flags, choices, vectors and colours that are told; a choice may be any of those that wrong calls have.
std::vector<Feature> features_of_parts(const Calls& calls, const std::vector<bool>& wrong,
                                       const std::vector<bool>& told);

/// That a direction is along an axis of the world, where a frame of one's own may have no second axis.
std::vector<Feature> features_of_axes(const std::vector<Direction>& directions);

/// Of the parts of right answers.
std::vector<Feature> features_of_answers(const Layout& result);

}  // namespace grade
