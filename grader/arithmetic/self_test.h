#pragma once

#include <string>

namespace grade {

/// What is wrong with the arithmetic of this process; empty: it is IEEE 754's, as written. Contraction into fused
/// multiply-adds, denormals that are flushed to 0, fast-math and another rounding mode give other bits than the
/// solution's, and verdicts that nobody could defend.
std::string arithmetic_fault();

}  // namespace grade
