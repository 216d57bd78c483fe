#pragma once

#include <vector>

#include "rt/files/image.h"

namespace grade {

/// How two pictures differ, by tile: means over some replicates of each, and how likely chance makes such a difference.
struct Tiles {
    static constexpr int side = 8;  // [pixel]

    int columns = 0, rows = 0;
    std::vector<double> mine, right;  // luminance, row by row from the top
    std::vector<double> t, p;         // Welch's test of their difference

    bool empty() const { return t.empty(); }

    /// The tile whose difference is least likely to be chance; of those, the largest.
    std::size_t clearest() const;
};

/// Of as many replicates of either, of one size.
Tiles compare_tiles(const std::vector<rt::Image>& mine, const std::vector<rt::Image>& right);

}  // namespace grade
