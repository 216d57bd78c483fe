#pragma once

#include <functional>
#include <string>
#include <vector>

#include "diagnosis/arguments.h"

namespace grade {

/// Numbers between a fragment's arguments and its answer, as the formula of its documentation has them: what is wrong
/// in the middle of a formula is a change of these.
struct Steps {
    std::string formula;                     // that makes the answer of them, in words; empty: their names say it
    std::vector<Signature::Argument> names;  // a bool is a mistake in words that is not made
    std::function<Row(const Row&)> take;     // of a row of arguments
    std::function<Row(const Row&)> finish;   // the answer, of a row of arguments and then steps
};

/// Cuts through the formula, each on its own; none for a fragment that has no formula here.
std::vector<Steps> steps_of(const std::string& fragment);

}  // namespace grade
