#pragma once

#include <string>

#include "record/record.h"

namespace grade {

/// The record as JSON, penumbra/result/v1. What depends on time and load is in keys that end in _seconds, nowhere else.
std::string to_json(const Record& record);

}  // namespace grade
