#pragma once

#include <cstddef>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace rt {

/// Memory for lists that rays read at places all over them: once a list is larger than a few megabytes, an ordinary
/// page of 4 KiB costs a search for its address nearly each time. Linux is asked for pages of 2 MiB; where it has none,
/// nothing changes.
template <class T>
struct LargePages {
    using value_type = T;
    static constexpr std::size_t page = std::size_t(1) << 21;

    LargePages() = default;
    template <class U>
    LargePages(const LargePages<U>&) {}

    static std::align_val_t alignment(std::size_t n) {
        return std::align_val_t(n * sizeof(T) < 2 * page ? alignof(T) : page);
    }

    T* allocate(std::size_t n) {
        void* const memory = ::operator new(n * sizeof(T), alignment(n));
#ifdef __linux__
        if (n * sizeof(T) >= 2 * page) madvise(memory, n * sizeof(T), MADV_HUGEPAGE);  // a wish: its answer is no error
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t n) { ::operator delete(memory, alignment(n)); }

    bool operator==(const LargePages&) const { return true; }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace rt
