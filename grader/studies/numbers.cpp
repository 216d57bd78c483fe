#include "studies/numbers.h"

#include <fmt/format.h>

#include <charconv>
#include <limits>

#include "rt/files/toml_table.h"

namespace grade {

namespace {

/// The number that a whole word is.
template <typename Number>
std::optional<Number> number_in(const std::string& word) {
    Number number{};
    const char* end = word.data() + word.size();
    const auto read = std::from_chars(word.data(), end, number);
    if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
    return number;
}

}  // namespace

std::optional<std::uint64_t> seed_in(const std::string& word) { return number_in<std::uint64_t>(word); }

CLI::Validator in_range(double low, double high) {
    const std::string range = fmt::format("{:g} to {:g}", low, high);
    const auto fault = [=](std::string& word) -> std::string {
        const auto number = number_in<double>(word);
        // nan is in no range
        if (number && *number >= low && *number <= high) return {};
        return fmt::format("{} is none; expected a number from {}", rt::in_quotes(word), range);
    };
    return {fault, range};
}

CLI::Validator is_seed() {
    constexpr auto most = std::numeric_limits<std::uint64_t>::max();
    const auto fault = [=](std::string& word) -> std::string {
        if (seed_in(word)) return {};
        return fmt::format("{} is none; expected a whole number from 0 to {}", rt::in_quotes(word), most);
    };
    return {fault, ""};
}

}  // namespace grade
