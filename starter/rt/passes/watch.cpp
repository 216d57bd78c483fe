#include "rt/passes/watch.h"

#include <algorithm>

namespace rt {

Watch::Watch(const RenderSettings& settings, int width, int height) : settings_(settings) {
    if (paints()) picture_ = Image(width, height);
}

void Watch::look(Real done, Real seconds_left) {
    if (!settings_.progress && !settings_.show) return;
    const Clock::time_point start = Clock::now();
    if (start < next_.load()) return;
    const std::unique_lock turn(turn_, std::try_to_lock);
    if (!turn) return;
    if (settings_.show) {
        {
            const std::lock_guard lock(picture_access_);
            copy_ = picture_;
        }
        settings_.show(copy_);
    }
    if (settings_.progress) settings_.progress(done, seconds_left);
    const Clock::time_point end = Clock::now();
    next_ = end + std::max<Clock::duration>(std::chrono::milliseconds(100), 10 * (end - start));
}

}  // namespace rt
