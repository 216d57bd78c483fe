#pragma once

#include <optional>

#include "diagnosis/calls/calls.h"

namespace grade {

/// What holds for all right answers, whatever random numbers they were made with, and not for mine.
struct Broken {
    std::string words;               // "`direction` must have length 1"
    std::size_t call;                // where it is broken most
    std::vector<std::size_t> calls;  // all in which it is
};

std::optional<Broken> broken_bound(const Calls& calls, const Ask& right);

/// Of rays from a surface, that they start on it: so close that calls look right, and pictures do not. Empty: they do
/// not, or leave out the first part of their way, always the same.
std::string starts_on_surface(const Calls& calls);

}  // namespace grade
