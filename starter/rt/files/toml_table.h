#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rt/files/words.h"
#include "rt/math.h"

/// Nobody needs this file for the assignment.
namespace rt {

/// Beyond this size the square of a product overflows.
constexpr Real huge = 1e70;

/// What a number must be.
struct Limits {
    Real low = -huge, high = huge;
    bool above = false, below = false;  // not low itself, not high itself
    bool or_inf = false;
    Real least = 0;           // of its size, whatever its sign
    const char* remark = "";  // on high

    bool hold(Real x) const;
    std::string expected() const;
};

inline constexpr Limits any_number{}, not_negative{.low = 0}, positive{.low = 0, .above = true};
/// What is seen as it is: a picture holds single precision.
inline constexpr Limits radiance{
    .low = 0, .high = std::numeric_limits<float>::max(), .remark = ", the largest that a picture holds"};
inline constexpr Limits positive_or_inf{.low = 0, .above = true, .or_inf = true};
inline constexpr Limits share{.low = 0, .high = 1};

/// A table of a TOML file. Every function throws InputError, with the position in the file, when what it finds is not
/// what it was asked for. Where `otherwise` is left out the key must be there.
class Table {
public:
    /// The whole file.
    static Table parse(std::string_view text, const std::string& path);

    /// Any other key is an error.
    void only(std::span<const std::string_view> keys) const;
    void only(std::initializer_list<std::string_view> keys) const { only(std::span(keys.begin(), keys.size())); }
    bool has(std::string_view key) const;
    std::vector<std::string> keys() const;

    Real number(std::string_view key, const Limits& limits, std::optional<Real> otherwise = {}) const;
    int integer(std::string_view key, int low, int high, std::optional<int> otherwise = {}) const;
    bool flag(std::string_view key, bool otherwise) const;
    std::string text(std::string_view key) const;
    vec3 vector(std::string_view key, const Limits& limits, std::optional<vec3> otherwise = {}) const;
    ivec2 pair(std::string_view key, int low, int high, std::optional<ivec2> otherwise = {}) const;

    /// Three numbers, or one for all three.
    Color color(std::string_view key, const Limits& limits, std::optional<Color> otherwise = {}) const;
    vec3 factors(std::string_view key, const Limits& limits) const;

    /// One of the words; returns its place in the list.
    int choice(std::string_view key, std::span<const std::string_view> words, std::optional<int> otherwise = {}) const;
    int choice(std::string_view key, std::initializer_list<std::string_view> words,
               std::optional<int> otherwise = {}) const {
        return choice(key, std::span(words.begin(), words.size()), otherwise);
    }

    /// The table [key]; none: an empty one.
    Table table(std::string_view key) const;

    /// The tables [[key]].
    std::vector<Table> tables(std::string_view key, bool required = false) const;

    /// Throws "file:line:column: wrong; expected ...", at the key, or at the table if the key is not there.
    [[noreturn]] void fail(std::string_view key, const std::string& wrong, const std::string& expected) const;

private:
    struct Inside;  // toml++'s types, whose header takes seconds to read
    std::shared_ptr<const Inside> inside_;
};

}  // namespace rt
