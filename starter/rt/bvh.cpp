#include "rt/bvh.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace rt {
namespace {

constexpr int bins = 16;
constexpr std::uint32_t leaf_size = 4;
constexpr int deepest = 80;  // below, lists are halved without a look at areas: the stack of traverse has a bound

struct Builder {
    const std::vector<Box>& boxes;
    std::vector<vec3> centers;
    Bvh bvh;

    struct Split {
        Real cost = inf;
        int axis = 0, bin = 0;
    };

    static int bin_of(Real x, Real low, Real extent) { return std::min(bins - 1, int(bins * ((x - low) / extent))); }

    /// The cheapest split of items between two bins of one axis.
    Split best_split(std::uint32_t begin, std::uint32_t end, const Box& middles) const {
        Split best;
        for (int axis = 0; axis < 3; ++axis) {
            const Real low = middles.low[axis], extent = middles.high[axis] - low;
            if (!(extent > 0)) continue;
            std::array<Box, bins> box;
            std::array<std::uint32_t, bins> count{};
            for (std::uint32_t i = begin; i < end; ++i) {
                const std::uint32_t item = bvh.items[i];
                const int b = bin_of(centers[item][axis], low, extent);
                box[b].include(boxes[item]);
                ++count[b];
            }
            std::array<Real, bins> right{};
            Box sum;
            std::uint32_t n = 0;
            for (int b = bins - 1; b > 0; --b) {
                sum.include(box[b]);
                n += count[b];
                right[b] = n * sum.half_area();
            }
            sum = Box{}, n = 0;
            for (int b = 1; b < bins; ++b) {
                sum.include(box[b - 1]);
                n += count[b - 1];
                const Real cost = n * sum.half_area() + right[b];
                if (n > 0 && n < end - begin && cost < best.cost) best = {cost, axis, b};
            }
        }
        return best;
    }

    void build(std::uint32_t begin, std::uint32_t end, int depth) {
        const std::size_t self = bvh.nodes.size();
        Box box, middles;
        for (std::uint32_t i = begin; i < end; ++i) {
            box.include(boxes[bvh.items[i]]);
            middles.include(centers[bvh.items[i]]);
        }
        bvh.nodes.push_back({box, begin, end - begin, 0});
        if (end - begin <= 1) return;

        const Split split = depth < deepest ? best_split(begin, end, middles) : Split{};
        const Real as_leaf = Real(end - begin) * box.half_area();
        if (end - begin <= leaf_size && !(split.cost + box.half_area() < as_leaf)) return;

        const auto from = bvh.items.begin() + begin, to = bvh.items.begin() + end;
        std::uint32_t middle;
        int axis = split.axis;
        if (split.cost < inf) {
            const Real low = middles.low[axis], extent = middles.high[axis] - low;
            middle = std::uint32_t(std::stable_partition(from, to, [&](std::uint32_t item) {
                         return bin_of(centers[item][axis], low, extent) < split.bin;
                     }) - bvh.items.begin());
        } else {  // all centres in one place, or too deep
            if (end - begin <= leaf_size) return;
            middle = begin + (end - begin) / 2;
        }
        bvh.nodes[self].count = 0;
        bvh.nodes[self].axis = std::uint32_t(axis);
        build(begin, middle, depth + 1);
        bvh.nodes[self].first = std::uint32_t(bvh.nodes.size());
        build(middle, end, depth + 1);
    }
};

}  // namespace

Bvh build_bvh(const std::vector<Box>& boxes) {
    Builder builder{boxes, {}, {}};
    builder.centers.reserve(boxes.size());
    for (const Box& box : boxes) builder.centers.push_back(box.center());
    builder.bvh.items.resize(boxes.size());
    std::iota(builder.bvh.items.begin(), builder.bvh.items.end(), 0u);
    if (!boxes.empty()) builder.build(0, std::uint32_t(boxes.size()), 0);
    return std::move(builder.bvh);
}

}  // namespace rt
