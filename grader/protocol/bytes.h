#pragma once

#include <cstddef>
#include <cstring>
#include <vector>

namespace grade {

/// std::memcpy, to which a null pointer is an error even where there is nothing to copy, as from an empty vector.
inline void copy_bytes(void* to, const void* from, std::size_t count) {
    if (count > 0) std::memcpy(to, from, count);
}

/// The numbers that bytes are, as many as are whole.
template <class Bytes>
std::vector<double> numbers_of_bytes(const Bytes& bytes) {
    std::vector<double> numbers(bytes.size() / sizeof(double));
    copy_bytes(numbers.data(), bytes.data(), numbers.size() * sizeof(double));
    return numbers;
}

}  // namespace grade
