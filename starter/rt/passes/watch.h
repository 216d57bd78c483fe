#pragma once

#include <atomic>
#include <chrono>
#include <mutex>

#include "rt/render.h"

namespace rt {

/// What there is of a picture while it is made, for who looks on a few times a second. Nobody needs this file for the
/// assignment.
class Watch {
public:
    explicit Watch(const RenderSettings& settings, int width, int height);

    /// A picture is copied for each look: none is kept where nobody looks.
    bool paints() const { return bool(settings_.show); }

    /// Puts some pixels into the picture: colour(k) is that of pixel k, counted row by row.
    template <class ColorOf>
    void paint(std::size_t first, std::size_t last, ColorOf color) {
        const std::lock_guard lock(picture_access_);
        for (std::size_t k = first; k < last; ++k) picture_.pixels[k] = color(k);
    }

    /// A look, if it is time for one. Any thread may call this; the others go on meanwhile. A look takes at most a
    /// tenth of a thread's time.
    void look(Real done, Real seconds_left);

private:
    using Clock = std::chrono::steady_clock;

    const RenderSettings& settings_;
    std::mutex picture_access_, turn_;
    Image picture_, copy_;
    std::atomic<Clock::time_point> next_{Clock::time_point{}};
};

}  // namespace rt
