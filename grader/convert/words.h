#pragma once

#include <string>

#include "record/record.h"

namespace grade {

/// A number as people write it: at most two decimals, no zeros at its end.
std::string short_number(double x);

/// What a fragment's result says in a few lines, without control characters: its verdict, what is wrong, where to read.
std::string words_on(const FragmentRecord& fragment);

/// "12.5 of 20 points"
std::string score_in_words(const Record& record);

}  // namespace grade
