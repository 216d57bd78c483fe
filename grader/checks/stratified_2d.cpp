#include <fmt/format.h>

#include <array>

#include "checks/fragment_checks.h"
#include "checks/kit/convergence.h"
#include "checks/kit/draw.h"
#include "checks/kit/figures.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/warp.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

struct Box {
    rt::vec2 low{rt::inf}, high{-rt::inf};

    void add(rt::vec2 p) { low = glm::min(low, p), high = glm::max(high, p); }
    double longest() const { return std::max(high.x - low.x, high.y - low.y); }
    double area() const { return (high.x - low.x) * (high.y - low.y); }
    double overlap(const Box& other) const {
        const rt::vec2 size = glm::min(high, other.high) - glm::max(low, other.low);
        return std::max(0.0, size.x) * std::max(0.0, size.y);
    }
};

/// The boxes around the points of each cell; the rows' i are the cells.
std::vector<Box> boxes(const Observation& seen, int n) {
    std::vector<Box> all(n);
    for (std::size_t k = 0; k < seen.inputs.size(); ++k)
        all[int(seen.inputs[k][0])].add({seen.outputs[k][0], seen.outputs[k][1]});
    return all;
}

Statistic about_cells(int n, std::string what, std::function<double(const std::vector<Box>&)> worst, double tolerance,
                      std::string hint) {
    Statistic s = property("G2", std::move(what), nullptr, tolerance, std::move(hint));
    s.measure = [=](const Observation& seen) { return worst(boxes(seen, n)); };
    return s;
}

/// Noise of N samples at the edges of a bright quad, over that of independent ones: N (L - p)^2 / (p (1 - p)), p the
/// share of the pixel that the quad covers.
Check edge_noise(Generator& random) {
    constexpr int samples = 16;
    const Place place = any_place(random);
    const rt::Quad q = any_quad(random, place, 0, 1);
    const std::string scene = toml(view_down(place, 5, 40)) + bright_lamp + quad("lamp", q);
    const rt::Camera camera = rt::parse_scene(scene, "edge_noise").camera;
    struct Edge {
        int x, y;
        double covered;
    };
    std::vector<Edge> edges;
    for (int y = 0; y < camera.size.y; ++y)
        for (int x = 0; x < camera.size.x; ++x) {
            double covered = 0;
            for (int part = 0; part < 16; ++part) {
                const auto sight = [&](rt::vec2 share) {
                    const rt::vec2 film = rt::vec2(x, y) + (rt::vec2(part % 4, part / 4) + share) / 4.0;
                    return on_quad(q, camera.eye, view_direction(camera, film)) ? 1.0 : 0.0;
                };
                covered += over_pixel(0, 0, sight) / 16;
            }
            if (covered > 0.15 && covered < 0.85) edges.push_back({x, y, covered});
        }
    Statistic noise = of_picture(
        "G2", "noise at edges, over that of independent samples",
        [edges](const rt::Image& image) {
            double sum = 0;
            for (const Edge& e : edges)
                sum += samples * rt::sqr(image.at(e.x, e.y).x - e.covered) / (e.covered * (1 - e.covered));
            return sum / double(edges.size());
        },
        0.2, 0.25,
        [](double value, double) {
            return fmt::format(
                "the noise at edges is {:.2g} of that of independent samples; cells leave about 0.2 with 16 samples: "
                "does each sample fall in a cell of "
                "its own, anywhere in it?",
                value);
        });
    noise.delta0 = 0.1;
    return render_check("edge_noise", {scene, samples, "stratified"}, {noise});
}

}  // namespace

Checks check_stratified_2d(Generator& random) {
    Checks checks;
    const int side = whole_between(random, 3, 5), odd = std::array{6, 7, 11, 13, 15}[whole_between(random, 0, 4)];
    for (const int n : {side * side, odd}) {
        // many points of each cell, with corners, so that their box is nearly the cell
        const auto inputs = [n](Generator& draws) {
            Rows rows;
            for (int i = 0; i < n; ++i)
                for (int k = 0; k < 96; ++k) {
                    const rt::vec2 u = square(draws);
                    rows.push_back(row(i, n, k < 4 ? rt::vec2(k % 2 ? 0.999999 : 0, k / 2 ? 0.999999 : 0) : u));
                }
            return repeat(rows);
        };
        const auto worst_of = [](auto measure) {
            return [=](const std::vector<Box>& all) {
                double worst = 0;
                for (std::size_t i = 0; i < all.size(); ++i) worst = std::max(worst, measure(all, i));
                return worst;
            };
        };
        Statistic inside = property(
            "G2", "distance outside the unit square",
            [](const Row&, const Row& out) {
                return std::max({0.0, -out[0], -out[1], out[0] >= 1 ? 1.0 : 0.0, out[1] >= 1 ? 1.0 : 0.0});
            },
            0, "points fall outside the unit square, 0 <= x < 1");
        Statistic area = about_cells(
            n, "area of a cell, off 1/n by its share",
            worst_of([n](const std::vector<Box>& all, std::size_t i) { return std::abs(all[i].area() * n - 1); }), 0.05,
            "a cell does not have the area 1/n: is u stretched over the cell, and is the number of columns a whole "
            "number, not an integer division?");
        area.cause = [n](const Observation& seen) -> std::string {
            const std::vector<Box> all = boxes(seen, n);
            double largest = 0;
            for (const Box& box : all) largest = std::max(largest, box.area());
            if (largest * n < 0.01)
                return "all points of a cell are one point, a regular grid: u says where in the cell";
            if (largest > 0.99) return "the cells are not used: the points are independent, anywhere in the square";
            return "";
        };
        Statistic shape = about_cells(
            n, "longest side of a cell, over 1/sqrt(n), beyond 2",
            worst_of([n](const std::vector<Box>& all, std::size_t i) {
                return std::max(0.0, all[i].longest() * std::sqrt(double(n)) - 2);
            }),
            0,
            "the cells are strips: only one axis is stratified; expected about sqrt(n) columns of about sqrt(n) cells");
        Statistic overlap = about_cells(n, "overlap of two cells, over their area",
            worst_of([n](const std::vector<Box>& all, std::size_t i) {
                double worst = 0;
                for (std::size_t j = 0; j < i; ++j) worst = std::max(worst, all[i].overlap(all[j]) * n);
                return worst;
            }), 0.01,
            "two cells overlap, so others stay empty: which cell is i, and how many columns does n give?");
        // points of random cells, not the corners: uniform on the whole square
        Statistic even = uniform_in_square("G2", "chi-squared of points of all cells",
            [](const Row& in, const Row& out) {
                const bool corner = (in[2] == 0 || in[2] == 0.999999) && (in[3] == 0 || in[3] == 0.999999);
                return corner ? rt::vec2(NAN) : rt::vec2(out[0], out[1]);
            },
            6, 6, always("the points of all cells together do not fill the square evenly"));
        even.delta0 = 1;  // stratified points are more even than random ones
        even.delta = 1.5;
        checks.push_back(probe_check(n == odd ? "any_number_of_cells" : "grid_of_cells", inputs,
                                     {inside, area, overlap, shape, even, purity()}));
    }
    checks.push_back(edge_noise(random));
    const SamplesOfASquare samples{[](rt::vec2, int i, int n, rt::vec2 u) { return row(i, n, u); },
                                   [](const Row&, const Row& out) {
                                       return SamplesOfASquare::Sample{{out[0], out[1]}};
                                   }};
    checks.push_back(error_orders(random, samples));
    checks.push_back(rings(random, samples));
    return checks;
}

}  // namespace grade
