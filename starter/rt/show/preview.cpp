#include "rt/show/preview.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "rt/show/encode.h"

namespace rt {
namespace {

constexpr int lines_below = 2;  // for the bar, and so that nothing scrolls

void write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = write(descriptor, bytes.data(), bytes.size());
        if (sent <= 0) return;  // the terminal is gone
        bytes.remove_prefix(std::size_t(sent));
    }
}

/// The picture of pixels in an image, as a PNG.
std::string png_of(const Shown& s) {
    Image image(s.width, s.height);
    return png_bytes(image);
}

}  // namespace

Drawing drawing_of(const Image& image, Real exposure, Graphics graphics, const TerminalSize& size) {
    const int rows = std::max(1, size.rows - lines_below);
    Drawing frame;
    if (graphics == Graphics::blocks) {
        const std::vector<std::string> lines = half_blocks(shown(image, exposure, size.columns, 2 * rows));
        for (const std::string& line : lines) frame.text += line + "\033[K\r\n";
        frame.rows = int(lines.size());
        return frame;
    }
    const Shown pixels = shown(image, exposure, size.columns * size.cell_width, rows * size.cell_height);
    frame.rows = (pixels.height + size.cell_height - 1) / size.cell_height;
    const std::string picture = graphics == Graphics::kitty ? kitty(png_of(pixels), frame.rows) : sixel(pixels);
    frame.text =
        fmt::format("\0337{}\0338\r\033[{}B", picture, frame.rows);  // from where the cursor was, that far down
    return frame;
}

void Preview::draw(const Image& image) {
    if (!in_foreground(descriptor_)) return;
    const TerminalSize size = size_of_terminal(descriptor_);
    const Drawing frame = drawing_of(image, exposure_, graphics_, size);
    // Room below the cursor, once; then back up to where the picture begins.
    const bool anew = frame.rows != rows_ || size.columns != columns_;
    const std::string room = anew ? std::string(std::size_t(frame.rows), '\n') : std::string();
    rows_ = frame.rows, columns_ = size.columns;
    // 2026: the terminal shows the frame at once; 25: the cursor.
    write_all(descriptor_, fmt::format("\033[?2026h\033[?25l\r\033[K{}\033[{}A{}\033[?25h\033[?2026l", room, frame.rows,
                                       frame.text));
}

}  // namespace rt
