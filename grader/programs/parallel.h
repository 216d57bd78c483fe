#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "files/interrupt.h"

namespace grade {

/// Does work(0) ... work(count - 1) on so many threads; 0: one for each core. The work is in other processes: these
/// threads wait for them. Throws the first exception that the work threw, after all threads have ended;
/// Interrupted after Ctrl-C.
inline void in_parallel(int count, int jobs, const std::function<void(int)>& work) {
    if (jobs <= 0) jobs = std::max(1, int(std::thread::hardware_concurrency()));
    std::atomic<int> next = 0;
    std::exception_ptr failure;
    std::mutex failure_lock;
    {
        std::vector<std::jthread> threads;
        for (int i = 0; i < std::min(jobs, count); ++i)
            threads.emplace_back([&] {
                for (int item; (item = next++) < count;) try {
                        check_interrupt();
                        work(item);
                    } catch (...) {
                        const std::scoped_lock lock(failure_lock);
                        if (!failure) failure = std::current_exception();
                        next = count;
                    }
            });
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace grade
