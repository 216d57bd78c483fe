#pragma once

#include <chrono>
#include <string_view>

/// What the terminal is like in which the program runs. Nobody needs this file for the assignment.
namespace rt {

/// How a terminal draws pictures: with pixels, if it can.
enum class Graphics { blocks, kitty, sixel };

struct TerminalSize {
    int columns = 80, rows = 24;
    int cell_width = 8, cell_height = 16;  // [pixel]
};

/// Whether a descriptor is a terminal that understands escape sequences.
bool can_draw(int descriptor);

/// Whether the shell has left the terminal to this program now.
bool in_foreground(int descriptor);

TerminalSize size_of_terminal(int descriptor);

/// Asks the terminal what it can, and waits so long for the answer at most.
Graphics ask_for_graphics(std::chrono::milliseconds patience);

/// What follows from the answer: to the questions whether it knows kitty's protocol and which attributes it has, one of
/// which, 4, is sixels.
Graphics graphics_of(std::string_view answer);

}  // namespace rt
