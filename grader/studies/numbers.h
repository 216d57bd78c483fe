#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <string>

/// Checks of numbers on the command line. CLI11's own take nan, and cut off what is too large.
namespace grade {

/// From low to high.
CLI::Validator in_range(double low, double high);

/// The seed that a whole word is; none: it is no number, or too large.
std::optional<std::uint64_t> seed_in(const std::string& word);

CLI::Validator is_seed();

}  // namespace grade
