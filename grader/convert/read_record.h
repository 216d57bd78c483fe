#pragma once

#include <filesystem>

#include "record/record.h"

namespace grade {

constexpr std::uint64_t most_record_bytes = 256u << 20;

/// The record of a file that `grade --json` or `grade class` wrote: without pictures, which only a new grading draws.
/// Throws rt::InputError for a file that is none, of an older grader's too, with what is wrong and where.
Record read_record(const std::filesystem::path& path);

/// The same of its text; path is for errors.
Record record_of(const std::string& text, const std::string& path);

}  // namespace grade
