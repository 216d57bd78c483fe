#include "programs/refuse.h"

#include <fmt/format.h>

#include <stdexcept>

#include "arithmetic/self_test.h"

namespace grade {

namespace {

/// The option among these that changes arithmetic; empty: none.
std::string changing_option(const Toolchain& chain) {
    std::string contraction = "the missing -ffp-contract=off", fast;
    for (const auto* list : {&chain.compile, &chain.link})
        for (const std::string& option : *list) {
            if (option.starts_with("-ffp-contract=")) contraction = option == "-ffp-contract=off" ? "" : option;
            for (const char* other : {"-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-ffinite-math-only",
                                      "-fassociative-math", "-freciprocal-math"})
                if (option == other) fast = option;
        }
    return fast.empty() ? contraction : fast;
}

}  // namespace

void refuse_other_arithmetic(const Toolchain& chain) {
    if (const std::string fault = arithmetic_fault(); !fault.empty())
        throw std::runtime_error(fmt::format(
            "it refuses to grade, since its own arithmetic is not exact: {}; expected plain IEEE 754", fault));
    if (const std::string option = changing_option(chain); !option.empty())
        throw std::runtime_error(
            fmt::format("it refuses to grade, since {} changes the arithmetic of fragments; expected -ffp-contract=off "
                        "and no fast-math",
                        option));
}

}  // namespace grade
