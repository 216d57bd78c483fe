#pragma once

#include <functional>

#include "rt/passes/schedule.h"
#include "rt/path.h"
#include "rt/render.h"

/// How threads share a picture, and when it is good enough. Nobody needs this folder for the assignment.
namespace rt {

/// Threads that share a picture: each pass renders every pixel of the crop, and some of them once more with other
/// random numbers, from which the error is estimated.
class Passes {
public:
    /// A part of the picture, pixels from first to last, counted row by row, is done; and so much of the pass.
    using Finished = std::function<void(std::size_t first, std::size_t last, Real share)>;

    Passes(const World& world, const RenderSettings& settings, Crop crop);

    /// Renders a pass, and tells what is finished, thread by thread. Returns whether all of it was; stop may end it
    /// before, though something is always done.
    bool run(const Slice& slice, const std::function<bool()>& stop, const Finished& finished);

    std::size_t pixels() const { return pixels_; }
    const std::vector<std::size_t>& control() const { return control_; }  // the pixels that are rendered twice
    const Color* means() const { return means_.data(); }                  // of the last pass
    const Color* again() const { return means_.data() + pixels_; }        // the control's second ones
    std::size_t done() const { return done_; }  // pixels of the last pass, the control's twice

    RayCounts rays{};
    std::optional<BadSample> bad_sample;  // the first there was

private:
    PixelWork work(std::size_t item, const Slice& slice) const;

    const World& world_;
    Crop crop_;
    std::size_t pixels_, done_ = 0;
    std::vector<std::size_t> control_;
    std::vector<Color> means_;
};

}  // namespace rt
