#pragma once

#include <bit>

#include "rt/sampler.h"

/// Which closed shapes a ray is in, all in one number: the regions' numbers side by side, the innermost in the lowest
/// bits. 0: in none. Regions have numbers from 1 on; of two, the one with the greater number is further in. Nobody
/// needs this file for the assignment.
///
/// A set, not a count: who enters a region twice leaves it once, so that no rounding at a boundary is remembered.
namespace rt {

/// How many bits each number takes, where there are so many regions.
constexpr int nesting_bits(std::size_t regions) { return std::bit_width(regions | 1); }

/// The innermost region; 0: none.
inline Bits innermost(Bits in, int bits) { return in & ((Bits(1) << bits) - 1); }

/// Those from place `at` on.
inline Bits further_out(Bits in, int at) { return at < 64 ? in >> at : 0; }

inline Bits left(Bits in, Bits region, int bits) {
    for (int at = 0; at + bits <= 64; at += bits)
        if (innermost(in >> at, bits) == region) {
            const Bits out = further_out(in, at + bits);
            return (in & ((Bits(1) << at) - 1)) | (out ? out << at : 0);
        }
    return in;
}

/// Where there is no room for all, the outermost is forgotten.
inline Bits entered(Bits in, Bits region, int bits) {
    in = left(in, region, bits);
    int at = 0;
    while (at + bits <= 64 && innermost(in >> at, bits) > region) at += bits;
    if (at + bits > 64) return in;
    const int used = 64 / bits * bits;
    const Bits all = used < 64 ? (Bits(1) << used) - 1 : ~Bits(0), out = in >> at;
    return ((in & ((Bits(1) << at) - 1)) | region << at | (at + bits < 64 ? out << (at + bits) : 0)) & all;
}

}  // namespace rt
