#pragma once

#include <functional>
#include <mutex>
#include <string>

namespace grade {

/// Steps of a grading, by what one of them takes: about so many hundredths of a second.
enum class Work : int { link = 10, check = 25, compile = 45 };

/// Tells how far a work of many steps is; from any thread, one at a time. What is expected before the first step is
/// done makes a time left that does not start anew with each kind of step.
class Progress {
public:
    using Listener = std::function<void(int done, int all, const std::string& doing)>;

    explicit Progress(Listener listener) : listener_(std::move(listener)) {}

    /// So many steps more, or fewer.
    void expect(Work work, int steps) {
        const std::scoped_lock lock(lock_);
        all_ += int(work) * steps;
    }

    void tell(const std::string& doing) {
        const std::scoped_lock lock(lock_);
        doing_ = doing;
        if (listener_) listener_(done_, all_, doing_);
    }

    /// A step is done.
    void done(Work work) {
        const std::scoped_lock lock(lock_);
        done_ += int(work);
        if (listener_) listener_(done_, all_, doing_);
    }

private:
    Listener listener_;
    std::mutex lock_;
    std::string doing_;
    int done_ = 0, all_ = 0;
};

}  // namespace grade
