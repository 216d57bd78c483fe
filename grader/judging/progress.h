#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace grade {

/// Tells how far a work of many steps is; from any thread, one at a time.
class Progress {
public:
    using Listener = std::function<void(int done, int all, const std::string& doing)>;

    explicit Progress(Listener listener) : listener_(std::move(listener)) {}

    /// So many steps more.
    void expect(int steps) {
        const std::scoped_lock lock(lock_);
        all_ += steps;
    }

    void tell(const std::string& doing, int steps_done = 0) {
        const std::scoped_lock lock(lock_);
        done_ += steps_done;
        if (listener_) listener_(done_, all_, doing);
    }

private:
    Listener listener_;
    std::mutex lock_;
    int done_ = 0, all_ = 0;
};

}  // namespace grade
