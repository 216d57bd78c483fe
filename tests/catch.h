#pragma once

/// Catch2, version 2 or 3, by the names of version 3.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
namespace Catch::Matchers {
inline auto ContainsSubstring(const std::string& words) { return Contains(words); }
}  // namespace Catch::Matchers
#endif

#include <exception>
#include <string>

/// What a function throws, in its words; empty: nothing.
template <class F>
std::string complaint_of(F function) {
    try {
        function();
        return "";
    } catch (const std::exception& error) {
        return error.what();
    }
}
