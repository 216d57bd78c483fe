#pragma once

#include <cstddef>
#include <cstring>

namespace grade {

/// std::memcpy, to which a null pointer is an error even where there is nothing to copy, as from an empty vector.
inline void copy_bytes(void* to, const void* from, std::size_t count) {
    if (count > 0) std::memcpy(to, from, count);
}

}  // namespace grade
