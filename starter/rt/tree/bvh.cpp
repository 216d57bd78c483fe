#include "rt/tree/bvh.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace rt {
namespace {

constexpr int bins = 32;
constexpr std::uint32_t piece_size = 1 << 14;  // of items whose tree is built by one thread
constexpr int halved_below = 18;  // levels at which lists are halved without a look at areas: depth has a bound

/// A box in the tree's space: low corner and minus the high corner, so that to join two is one minimum of 8 numbers.
/// The fourth number of an item's box is the item, bit by bit.
struct alignas(32) FloatBox {
    float v[8] = {1e30f, 1e30f, 1e30f, 0, 1e30f, 1e30f, 1e30f, 0};

    void include(const FloatBox& b) {
        for (int k = 0; k < 8; ++k) v[k] = b.v[k] < v[k] ? b.v[k] : v[k];
    }
    float twice_center(int axis) const { return v[axis] - v[4 + axis]; }
    float extent(int axis) const { return -v[4 + axis] - v[axis]; }
    /// The point at twice the centre.
    FloatBox middle() const {
        FloatBox point;
        for (int a = 0; a < 3; ++a) point.v[a] = twice_center(a), point.v[4 + a] = -point.v[a];
        return point;
    }
    float half_area() const {
        const float x = extent(0), y = extent(1), z = extent(2);
        return x < 0 ? 0 : x * y + y * z + z * x;
    }
    std::uint32_t item() const { return std::bit_cast<std::uint32_t>(v[3]); }
};

/// Items first to last - 1 of the list, which are to become one child.
struct Range {
    std::uint32_t first = 0, last = 0;
    FloatBox box{}, middles{};  // the second, of twice the centres
    std::uint32_t count() const { return last - first; }
};

/// The children of one node.
class Children {
public:
    Range* begin() { return all_; }
    Range* end() { return all_ + count_; }
    std::size_t size() const { return count_; }
    Range& operator[](std::size_t c) { return all_[c]; }
    void push_back(const Range& range) { all_[count_++] = range; }

private:
    Range all_[Bvh::width];
    std::size_t count_ = 0;
};

/// What a list holds by where the items' centres are along each axis.
struct Bins {
    FloatBox box[3][bins];
    std::uint32_t count[3][bins] = {};
    std::uint32_t occupied[3] = {};  // bit by bit

    void include(int axis, int bin, const FloatBox& item) {
        box[axis][bin].include(item), ++count[axis][bin], occupied[axis] |= 1u << bin;
    }
};

/// A plane between bins, and what is on either side of it.
struct Plane {
    int axis = 0, bin = 0;  // the first bin beyond; 0: there is none
    FloatBox left, right;
};

/// The cheapest one: fewest items times area of their box.
Plane cheapest(const Bins& all) {
    Plane best;
    float least = std::numeric_limits<float>::infinity();
    for (int a = 0; a < 3; ++a) {
        float right[bins];  // of the bins from this one on
        FloatBox sum;
        std::uint32_t n = 0;
        for (std::uint32_t left = all.occupied[a]; left != 0; left &= ~(1u << (std::bit_width(left) - 1))) {
            const int b = int(std::bit_width(left)) - 1;
            sum.include(all.box[a][b]);
            right[b] = float(n += all.count[a][b]) * sum.half_area();
        }
        sum = {}, n = 0;
        for (std::uint32_t left = all.occupied[a]; (left & (left - 1)) != 0;) {
            const int b = std::countr_zero(left);
            sum.include(all.box[a][b]), n += all.count[a][b], left &= left - 1;
            const float cost = float(n) * sum.half_area() + right[std::countr_zero(left)];
            if (cost < least) least = cost, best.axis = a, best.bin = b + 1;
        }
    }
    for (std::uint32_t left = best.bin > 0 ? all.occupied[best.axis] : 0; left != 0; left &= left - 1) {
        const int b = std::countr_zero(left);
        (b < best.bin ? best.left : best.right).include(all.box[best.axis][b]);
    }
    return best;
}

/// A subtree that waits for its thread: where it hangs, and what is in it.
struct Piece {
    std::size_t node;
    int child;
    Range range;
    int depth;
    LargeVector<Bvh::Node> nodes;
};

struct Builder {
    LargeVector<FloatBox> items;
    std::vector<Piece> pieces;

    Range list(std::uint32_t first, std::uint32_t last) const {
        Range all{first, last, {}};
        for (std::uint32_t i = first; i < last; ++i) all.box.include(items[i]), all.middles.include(items[i].middle());
        return all;
    }

    /// Splits a list in two, at the cheapest of the planes between bins.
    std::pair<Range, Range> split(const Range& range, int depth) {
        float low[3], per_unit[3];
        for (int a = 0; a < 3; ++a) {
            low[a] = range.middles.v[a];
            const float extent = range.middles.extent(a);
            per_unit[a] = extent > 0 ? 0.999f * bins / extent : 0;
            if (!(per_unit[a] < 1e30f)) per_unit[a] = 0;
        }
        const auto bin_of = [&](const FloatBox& item, int a) {
            return int((item.twice_center(a) - low[a]) * per_unit[a]);
        };
        if (depth < halved_below) {
            Bins all;
            for (std::uint32_t i = range.first; i < range.last; ++i)
                for (int a = 0; a < 3; ++a) all.include(a, bin_of(items[i], a), items[i]);
            if (const Plane plane = cheapest(all); plane.bin > 0)
                return split(range, plane, [&](const FloatBox& item) { return bin_of(item, plane.axis) < plane.bin; });
        }
        const std::uint32_t middle = range.first + range.count() / 2;  // all centres in one place, or too deep
        return {list(range.first, middle), list(middle, range.last)};
    }

    /// The items that are on the left come first.
    template <class IsLeft>
    std::pair<Range, Range> split(const Range& range, const Plane& plane, IsLeft is_left) {
        Range left{range.first, range.first, plane.left}, right{range.last, range.last, plane.right};
        const auto add_left = [&] { left.middles.include(items[left.last++].middle()); };
        const auto add_right = [&] { right.middles.include(items[--right.first].middle()); };
        for (;;) {
            while (left.last < right.first && is_left(items[left.last])) add_left();
            while (left.last < right.first && !is_left(items[right.first - 1])) add_right();
            if (left.last == right.first) return {left, right};
            std::swap(items[left.last], items[right.first - 1]);
            add_left(), add_right();
        }
    }

    /// The children of a node: items, or lists of which the largest is split until there are eight.
    Children children_of(const Range& range, int depth) {
        Children children;
        if (range.count() <= Bvh::width) {
            for (std::uint32_t i = range.first; i < range.last; ++i) children.push_back({i, i + 1, items[i]});
            return children;
        }
        children.push_back(range);
        const auto size = [&](const Range& r) {
            return std::pair(depth < halved_below ? r.box.half_area() : 0, r.count());
        };
        while (children.size() < Bvh::width) {
            auto largest = children.end();
            for (auto c = children.begin(); c != children.end(); ++c)
                if (c->count() > Bvh::width && (largest == children.end() || size(*c) > size(*largest))) largest = c;
            if (largest == children.end()) break;
            const auto [left, right] = split(*largest, depth);
            *largest = left;
            children.push_back(right);
        }
        return children;
    }

    /// Puts the children in order along the axis along which they are the most apart. Returns the axis.
    static int sort(Children& children) {
        FloatBox middles;
        for (const Range& c : children) middles.include(c.box.middle());
        int axis = 0;
        for (int a = 1; a < 3; ++a)
            if (middles.extent(a) > middles.extent(axis)) axis = a;
        const auto is_before = [axis](const Range& a, const Range& b) {
            return a.box.twice_center(axis) < b.box.twice_center(axis);
        };
        // by insertion: libstdc++ does not align the buffer of std::stable_sort as boxes must be
        for (auto next = children.begin(); next != children.end(); ++next)
            std::rotate(std::upper_bound(children.begin(), next, *next, is_before), next, next + 1);
        return axis;
    }

    /// Appends the nodes over a list; with pieces, leaves the small lists to them. Returns the number of the first.
    std::uint32_t build(const Range& range, int depth, bool in_pieces, LargeVector<Bvh::Node>& nodes) {
        const std::size_t self = nodes.size();
        nodes.emplace_back();
        nodes[self].leaf = range.count() <= Bvh::width ? ~0u : 0u;
        Children children = children_of(range, depth);
        nodes[self].axis = std::uint32_t(sort(children));
        for (std::size_t c = 0; c < Bvh::width; ++c) {
            const FloatBox box = c < children.size() ? children[c].box : FloatBox{};
            for (int a = 0; a < 3; ++a) {
                nodes[self].bound[a][0][c] = box.v[a];
                nodes[self].bound[a][1][c] = -box.v[4 + a];
            }
            if (c >= children.size()) continue;
            if (nodes[self].leaf) {
                nodes[self].child[c] = items[children[c].first].item();
            } else if (in_pieces && children[c].count() <= piece_size) {
                pieces.push_back({self, int(c), children[c], depth + 1, {}});
            } else {
                const std::uint32_t child = build(children[c], depth + 1, in_pieces, nodes);
                nodes[self].child[c] = child;
            }
        }
        return std::uint32_t(self);
    }

    void build_pieces(LargeVector<Bvh::Node>& nodes) {
        tbb::parallel_for(std::size_t(0), pieces.size(), [&](std::size_t k) {
            Piece& piece = pieces[k];
            piece.nodes.reserve(piece.range.count() / 4 + 1);
            build(piece.range, piece.depth, false, piece.nodes);
        });
        items = LargeVector<FloatBox>();  // gives the memory back, as = {} does not
        std::size_t all = nodes.size();
        for (const Piece& piece : pieces) all += piece.nodes.size();
        nodes.reserve(all);
        for (Piece& piece : pieces) {
            const std::uint32_t offset = std::uint32_t(nodes.size());
            nodes[piece.node].child[piece.child] = offset;
            for (Bvh::Node& node : piece.nodes) {
                for (std::uint32_t& child : node.child) child += node.leaf ? 0 : offset;
                nodes.push_back(node);
            }
            piece.nodes = LargeVector<Bvh::Node>();
        }
    }
};

}  // namespace

Bvh build_bvh(std::size_t n, const std::function<Box(std::size_t)>& box) {
    Bvh bvh;
    if (n == 0) return bvh;
    for (std::size_t i = 0; i < n; ++i) bvh.whole.include(box(i));
    bvh.center = 0.5 * bvh.whole.low + 0.5 * bvh.whole.high;
    int exponent = 0;
    std::frexp(largest(bvh.whole.high - bvh.center), &exponent);
    bvh.scale = std::ldexp(1.0, -exponent);

    Builder builder;
    builder.items.resize(n);
    tbb::parallel_for(std::size_t(0), n, [&](std::size_t i) {
        const Box b = box(i);
        FloatBox& item = builder.items[i];
        for (int a = 0; a < 3; ++a) {
            item.v[a] = float((b.low[a] - bvh.center[a]) * bvh.scale);
            item.v[4 + a] = float((bvh.center[a] - b.high[a]) * bvh.scale);
        }
        item.v[3] = std::bit_cast<float>(std::uint32_t(i));
    });
    builder.build(builder.list(0, std::uint32_t(n)), 0, true, bvh.nodes);
    builder.build_pieces(bvh.nodes);
    return bvh;
}

void add_corners(Bvh& bvh, const std::function<const Triangle*(std::size_t)>& triangle) {
    std::uint32_t leaves = 0;
    for (Bvh::Node& node : bvh.nodes)
        if (node.leaf) node.corners = leaves++;
    bvh.corners.resize(leaves);
    tbb::parallel_for(std::size_t(0), bvh.nodes.size(), [&](std::size_t k) {
        const Bvh::Node& node = bvh.nodes[k];
        if (!node.leaf) return;
        for (int c = 0; c < Bvh::width && node.bound[0][0][c] <= node.bound[0][1][c]; ++c)
            if (const Triangle* const t = triangle(node.child[c])) {
                const vec3 corner[3] = {t->a, t->b, t->c};
                for (int v = 0; v < 3; ++v)
                    for (int a = 0; a < 3; ++a)
                        bvh.corners[node.corners].at[v][a][c] = float((corner[v][a] - bvh.center[a]) * bvh.scale);
            }
    });
}

}  // namespace rt
