/// The tree of boxes: what is in it, how deep it is, and how many nodes a ray looks at. What it finds is tested against
/// brute force in extremes/trees_test.cpp.

#include <tbb/global_control.h>

#include <cstring>

#include "extremes/meshes.h"
#include "rt/fragments.h"
#include "rt/tree/traverse.h"

using namespace rt;

namespace {

std::vector<Box> random_boxes(int n, Random& random) {
    std::vector<Box> boxes(static_cast<std::size_t>(n));
    for (Box& box : boxes) {
        const vec3 p = random.in_cube();
        box.include(p), box.include(p + 0.1 * random.number() * random.in_cube());
    }
    return boxes;
}

Bvh tree_of(const std::vector<Box>& boxes) {
    return build_bvh(boxes.size(), [&](std::size_t i) { return boxes[i]; });
}

struct Walk {
    const Bvh& bvh;
    const std::vector<Box>& boxes;
    std::vector<int> seen;
    int deepest = 0, outside = 0, out_of_order = 0;

    /// All below a node; bounds of its box, in the tree's space.
    void visit(std::uint32_t at, vec3 low, vec3 high, int depth) {
        const Bvh::Node& node = bvh.nodes[at];
        deepest = std::max(deepest, depth);
        Real last = -inf;
        for (int c = 0; c < Bvh::width; ++c) {
            if (node.bound[0][0][c] > node.bound[0][1][c]) continue;
            vec3 child_low, child_high;
            for (int a = 0; a < 3; ++a) child_low[a] = node.bound[a][0][c], child_high[a] = node.bound[a][1][c];
            const Real middle = node.bound[node.axis][0][c] + node.bound[node.axis][1][c];
            out_of_order += middle < last, last = middle;
            for (int a = 0; a < 3; ++a) outside += child_low[a] < low[a] || child_high[a] > high[a];
            if (!node.leaf) {
                visit(node.child[c], child_low, child_high, depth + 1);
                continue;
            }
            ++seen[node.child[c]];
            const Box& box = boxes[node.child[c]];
            for (int a = 0; a < 3; ++a) {
                const Real rounding = box_margin / 32;
                outside += (box.low[a] - bvh.center[a]) * bvh.scale < child_low[a] - rounding;
                outside += (box.high[a] - bvh.center[a]) * bvh.scale > child_high[a] + rounding;
            }
        }
    }
};

Walk walk(const Bvh& bvh, const std::vector<Box>& boxes) {
    Walk w{bvh, boxes, std::vector<int>(boxes.size(), 0)};
    if (!bvh.nodes.empty()) w.visit(0, vec3(-1.001), vec3(1.001), 1);
    return w;
}

void check_tree(const std::vector<Box>& boxes) {
    const Bvh bvh = tree_of(boxes);
    const Walk w = walk(bvh, boxes);
    INFO(boxes.size() << " boxes, " << bvh.nodes.size() << " nodes");
    CHECK(std::count(w.seen.begin(), w.seen.end(), 1) == std::ptrdiff_t(boxes.size()));
    CHECK(w.outside == 0);
    CHECK(w.out_of_order == 0);
    CHECK(w.deepest <= Bvh::deepest);
}

bool same(const Bvh& a, const Bvh& b) {
    return a.nodes.size() == b.nodes.size() &&
           std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(Bvh::Node)) == 0;
}

/// Nodes that a ray through a ball looks at, on average.
Real looks(int level) {
    Random random(5);
    const Mesh mesh = ball(level, 0, random);
    std::vector<Triangle> triangles;
    for (const glm::ivec3 t : mesh.triangles)
        triangles.push_back(
            {mesh.vertices[std::size_t(t.x)], mesh.vertices[std::size_t(t.y)], mesh.vertices[std::size_t(t.z)]});
    std::vector<Box> boxes(triangles.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i].include(triangles[i].a), boxes[i].include(triangles[i].b), boxes[i].include(triangles[i].c);
    const Bvh bvh = tree_of(boxes);
    std::int64_t nodes = 0;
    const int batches = 64;
    static Journeys journeys;
    static Meetings meetings;
    static Visits visits;
    for (int k = 0; k < batches; ++k) {
        Batch b{};
        b.count = lanes;
        for (int i = 0; i < lanes; ++i) {
            const vec3 eye = random.vector(2, 4);
            b.set_ray(i, {eye, unit(0.9 * random.in_cube() - eye), 0, inf});
        }
        start(bvh, b, journeys);
        begin(journeys, true);
        for (;;) {
            int rays[lanes], n = 0;
            for (int i = 0; i < lanes; ++i)
                if (journeys.depth[i] > 0) rays[n++] = i;
            if (n == 0) break;
            nodes += n;
            meetings.count = 0;
            for (int k = 0; k < n; ++k) step(bvh.nodes.data(), journeys, rays[k], visits);
            for (; visits.count > 0; --visits.count) {
                const int k = visits.count - 1;
                add_pairs(bvh.nodes[visits.node[k]], visits.lane[k], visits.met[k], meetings);
            }
            for (int m = 0; m < meetings.count; ++m) {
                const int i = int(meetings.lane(m));
                const Real t = hit_triangle(triangles[std::size_t(meetings.item(m))], b.ray(i));
                if (t < b.far[i]) b.far[i] = t, shorten(journeys, i, t);
            }
        }
    }
    return Real(nodes) / (batches * lanes);
}

}  // namespace

TEST_CASE("every item is in one leaf, and within all boxes above it") {
    Random random(1);
    for (const int n : {1, 2, 7, 8, 9, 64, 1000, 40000}) check_tree(random_boxes(n, random));
}

TEST_CASE("no items, no nodes") { CHECK(tree_of({}).nodes.empty()); }

TEST_CASE("the depth has a bound: all boxes in one place, each half as large as the one before, flat") {
    Box one;
    one.include(vec3(1, 2, 3)), one.include(vec3(2, 3, 4));
    check_tree(std::vector<Box>(100000, one));
    std::vector<Box> halves(1000), flat(1000);
    for (int i = 0; i < 1000; ++i) {
        Box &half = halves[std::size_t(i)], &square = flat[std::size_t(i)];
        half.include(vec3(power_of_two(-i))), half.include(vec3(power_of_two(-i - 1)));
        square.include(vec3(i, 0, 0)), square.include(vec3(i + 1, 0, 0));
    }
    check_tree(halves);
    check_tree(flat);
    check_tree({Box{vec3(1), vec3(1)}, Box{vec3(1), vec3(1)}});
}

TEST_CASE("the tree does not depend on the number of threads") {
    Random random(2);
    const std::vector<Box> boxes = random_boxes(100000, random);
    const Bvh many = tree_of(boxes);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(same(many, tree_of(boxes)));
}

TEST_CASE("nor on the scale, from 2^-200 to 2^200") {
    Random random(3);
    std::vector<Box> boxes = random_boxes(2000, random);
    const Bvh unscaled = tree_of(boxes);
    for (const int k : {-200, -40, 40, 200}) {
        std::vector<Box> scaled = boxes;
        for (Box& box : scaled) box.low *= power_of_two(k), box.high *= power_of_two(k);
        CHECK(same(unscaled, tree_of(scaled)));
    }
}

TEST_CASE("the nodes that a ray looks at grow with the logarithm of the triangles, or less") {
    const Real few = looks(2), some = looks(4), many = looks(6);  // 320, 5,120 and 81,920 triangles
    INFO(few << " nodes a ray, " << some << ", " << many);
    CHECK(few > 1);
    CHECK(many - some <= 1.05 * (some - few));
    CHECK(many <= 12);
}

TEST_CASE("a tree has at most 70 bytes a triangle") {
    Random random(4);
    const Bvh bvh = tree_of(random_boxes(100000, random));
    CHECK(bvh.nodes.size() * sizeof(Bvh::Node) <= 70u * 100000);
}
