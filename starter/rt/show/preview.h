#pragma once

#include "rt/files/image.h"
#include "rt/show/terminal.h"

namespace rt {

/// A picture in the terminal, drawn again in its place whenever there is more of it. The cursor is on the line below
/// it, and seen, whenever no frame is being written: whatever ends the program leaves the terminal as it was. Nobody
/// needs this file for the assignment.
class Preview {
public:
    /// descriptor  of the terminal
    Preview(int descriptor, Graphics graphics, Real exposure)
        : descriptor_(descriptor), graphics_(graphics), exposure_(exposure) {}

    /// Draws where the last frame was; below it, if the terminal has another size now. Not while in the background.
    void draw(const Image& image);

private:
    int descriptor_;
    Graphics graphics_;
    Real exposure_;
    int rows_ = 0, columns_ = 0;  // of the last frame, and of the terminal then
};

/// What a frame draws: the lines that the picture takes, and what draws it and leaves the cursor below.
struct Drawing {
    int rows = 0;
    std::string text;
};
Drawing drawing_of(const Image& image, Real exposure, Graphics graphics, const TerminalSize& size);

}  // namespace rt
