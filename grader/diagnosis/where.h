#pragma once

#include "diagnosis/calls.h"

namespace grade {

/// What sets wrong calls apart from right ones: "where `dot(n, to_light) < 0`"; empty where nothing does.
std::string where_wrong(const Calls& calls);

}  // namespace grade
