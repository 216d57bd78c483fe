#pragma once

#include <algorithm>
#include <functional>
#include <mutex>

namespace grade {

/// What all answers of a fragment may take together, in all its checks: a time for whatever it does, and so many times
/// what the solution needs for the same answers.
class Budget {
public:
    static constexpr double free_seconds = 30, times = 60;

    /// Whether there is any left. From any thread.
    ///
    /// counted  what of this check is counted already; 0 at first
    /// seconds  its answers have taken so far
    /// needed   what the solution needs for them; asked for only when that may matter, since it may have to run for it
    bool covers(double& counted, double seconds, const std::function<double()>& needed) {
        constexpr double little = 5;
        const double counts = seconds < little ? seconds : std::max(0.0, seconds - times * needed());
        const std::scoped_lock lock(lock_);
        spent_ += counts - counted;
        counted = counts;
        return spent_ <= free_seconds;
    }

private:
    std::mutex lock_;
    double spent_ = 0;
};

}  // namespace grade
