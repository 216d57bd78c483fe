#pragma once

#include <string>

#include "record/record.h"

namespace grade {

/// What a record calls itself.
constexpr const char* record_schema = "penumbra/result/v2";

/// The record as JSON: record/README.md says what each field is, record/result.schema.json which there are. What
/// depends on time and load is in `date` and in keys that end in _seconds, nowhere else.
std::string to_json(const Record& record);

/// The same with all of that 0 or empty: of two gradings of the same texts with the same seed, these are one text.
std::string timeless_json(Record record);

}  // namespace grade
