#pragma once

namespace grade::textbook {

/// A byte of a form's text as it stands in the program, and back: who looks through a kit for strings reads no formula.
constexpr unsigned char hidden(char c) { return static_cast<unsigned char>(static_cast<unsigned char>(c) ^ 0xa5u); }
constexpr char shown(unsigned char c) { return static_cast<char>(c ^ 0xa5u); }

}  // namespace grade::textbook
