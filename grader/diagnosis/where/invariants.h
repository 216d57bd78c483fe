#pragma once

#include "diagnosis/calls/calls.h"

namespace grade {

/// What all calls have in common: ranges, unit vectors, right angles, which of two is larger.
class Invariants {
public:
    explicit Invariants(const Calls& calls);

    /// With what must be the same made so; false where something else would not hold any more.
    bool mend(Row& row, std::size_t changed) const;

private:
    struct Range {
        std::size_t part, component;
        double low, high;
    };
    struct Ordered {
        std::size_t a, b, component;
        bool strictly;  // a < b, else a <= b
    };
    struct Side {
        std::size_t a, b;
        double sign;  // of their dot product
    };
    const Signature& signature_;
    std::vector<Range> ranges_;
    std::vector<Side> sides_;
    std::vector<std::size_t> unit_, not_zero_;
    std::vector<std::pair<std::size_t, std::size_t>> right_angles_, same_;
    std::vector<Ordered> ordered_;
};

}  // namespace grade
