#include "asked/stratified_2d.h"
#include "checks/kit/convergence.h"
#include "checks/kit/figures.h"
#include "checks/kit/kit.h"

namespace grade {

namespace {

using rt::vec2;

struct CellBox {
    vec2 low{rt::inf}, high{-rt::inf};

    void add(vec2 p) { low = glm::min(low, p), high = glm::max(high, p); }
    double longest() const { return std::max(high.x - low.x, high.y - low.y); }
    double area() const { return (high.x - low.x) * (high.y - low.y); }
    double overlap(const CellBox& other) const {
        const vec2 size = glm::min(high, other.high) - glm::max(low, other.low);
        return std::max(0.0, size.x) * std::max(0.0, size.y);
    }
};

/// The boxes around the points of each of n cells; the rows' i are the cells.
std::vector<CellBox> boxes(const Observation& seen, int n) {
    std::vector<CellBox> all(n);
    for (std::size_t k = 0; k < seen.inputs.size(); ++k)
        if (argument<rt::stratified_2d, 1>(seen.inputs[k]) == n)
            all[argument<rt::stratified_2d, 0>(seen.inputs[k])].add(result<rt::stratified_2d>(seen.outputs[k]));
    return all;
}

/// The worst of all cells of each number: violation(all, i).
template <class Violation>
Statistic about_cells(const std::vector<int>& numbers, const std::string& what, double tolerance,
                      const std::string& says, Violation violation) {
    Statistic s = property({.id = "G2", .what = what, .tolerance = tolerance, .says = says});
    s.measure = [=](const Observation& seen) {
        double worst = 0;
        for (const int n : numbers) {
            const std::vector<CellBox> all = boxes(seen, n);
            for (std::size_t i = 0; i < all.size(); ++i) worst = std::max(worst, violation(all, i));
        }
        return worst;
    };
    return s;
}

std::string no_cells(const Observation& seen, int n) {
    double largest = 0;
    bool are_of_rooks = n > 1;
    for (const CellBox& box : boxes(seen, n)) {
        largest = std::max(largest, box.area());
        are_of_rooks = are_of_rooks && std::abs(box.longest() * n - 1) < 0.05 && std::abs(box.area() * n * n - 1) < 0.1;
    }
    if (are_of_rooks)
        return "a cell is 1/n wide and 1/n high, as of n rooks on a board: most of the square stays empty; expected "
               "cells of the area 1/n";
    if (largest * n < 0.01) return "all points of a cell are one point, a regular grid: u says where in the cell";
    if (largest > 0.99) return "the cells are not used: the points are independent, anywhere in the square";
    return "";
}

/// Columns: cells beside each other that begin at different x.
std::string columns_of(const Observation& seen, int n) {
    const std::vector<CellBox> all = boxes(seen, n);
    const auto different = [&](auto begins) {
        std::vector<double> list;
        for (const CellBox& box : all) list.push_back(begins(box));
        std::ranges::sort(list);
        int count = 1;
        for (std::size_t i = 1; i < list.size(); ++i) count += list[i] - list[i - 1] > 0.1 / n;
        return count;
    };
    const int columns = different([](const CellBox&box) { return box.low.x; }),
              rows = different([](const CellBox&box) { return box.low.y; });
    if (columns == 1 || rows == 1)
        return "the cells are strips: only one axis is stratified; expected about sqrt(n) columns of about sqrt(n) "
               "cells";
    return fmt::format("{} cells are in {} columns; expected {}: is sqrt(n) rounded down?", n, columns,
                       int(std::sqrt(double(n))));
}

/// Whether what lies outside is at 1.
std::string rounded_up(const Observation& seen) {
    for (const Row& out : seen.outputs) {
        const vec2 p = result<rt::stratified_2d>(out);
        if (!(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1)) return "";
    }
    return "the greatest u below 1 gives a coordinate of 1, since i + u is rounded up: never return more than "
           "below_one";
}

constexpr double near_middle = 1e-3;

/// Many points of each cell, with corners, so that their box is nearly the cell; of a folded map it is the middle.
std::function<Rows(Generator&)> points_of_cells(const std::vector<int>& numbers, double greatest) {
    return with_repeats([=](Generator& draws) {
        Rows rows;
        for (const int n : numbers)
            for (int i = 0; i < n; ++i)
                for (int k = 0; k < (n > 30 ? 11 : 160); ++k) {
                    const double places[] = {0, greatest, 0.5 + between(draws, -near_middle, near_middle)};
                    const vec2 u = square(draws);
                    rows.push_back(row(i, n, k < 9 ? vec2(places[k % 3], places[k / 3]) : u));
                }
        return rows;
    });
}

/// greatest  in the corners of the cells; below_one: i + u is rounded up
Check cells(const std::string& name, const std::vector<int>& numbers, double greatest = 0.999999) {
    Statistic inside = property({.id = "G2",
                                 .what = "distance outside the unit square",
                                 .violation = of_call<rt::stratified_2d>([](vec2 p) {
                                     return std::max({0.0, -p.x, -p.y, p.x >= 1 || p.y >= 1 ? 1.0 : 0.0});
                                 }),
                                 .says = "points fall outside the unit square, 0 <= x < 1"});
    inside.cause = rounded_up;
    Statistic area = about_cells(
        numbers, "area of a cell, off 1/n by its share", 0.01,
        "a cell does not have the area 1/n: is u stretched over the cell, and is the number of columns a whole number, "
        "not an integer division?",
        [](const std::vector<CellBox>& all, std::size_t i) {
            return std::abs(all[i].area() * double(all.size()) - 1);
        });
    area.cause = [numbers](const Observation& seen) { return no_cells(seen, numbers.front()); };
    const auto too_long = [](const std::vector<CellBox>& all, std::size_t i) {
        return std::max(0.0, all[i].longest() * std::sqrt(double(all.size())) - 2);
    };
    Statistic shape =
        about_cells(numbers, "longest side of a cell, over 1/sqrt(n), beyond 2", 0,
                    "cells are too long; expected about sqrt(n) columns of about sqrt(n) cells", too_long);
    shape.cause = [=](const Observation& seen) -> std::string {
        for (const int n : numbers) {
            const std::vector<CellBox> all = boxes(seen, n);
            for (std::size_t i = 0; i < all.size(); ++i)
                if (too_long(all, i) > 0) return columns_of(seen, n);
        }
        return "";
    };
    const Statistic overlap =
        about_cells(numbers, "overlap of two cells, over their area", 0.01,
                    "two cells overlap, so others stay empty: which cell is i, and how many columns does n give?",
                    [](const std::vector<CellBox>& all, std::size_t i) {
                        double worst = 0;
                        for (std::size_t j = 0; j < i; ++j)
                            worst = std::max(worst, all[i].overlap(all[j]) * double(all.size()));
                        return worst;
                    });
    // points of random cells, not the corners: uniform on the whole square, and more even than random ones
    const Statistic even = uniform_in_square(
        {.id = "G2",
         .what = "chi-squared of points of all cells",
         .point = of_call<rt::stratified_2d>([=](vec2 p, int, int, vec2 u) {
             const auto is_drawn = [=](double x) { return x != 0 && x != greatest && std::abs(x - 0.5) > near_middle; };
             return is_drawn(u.x) || is_drawn(u.y) ? p : vec2(NAN);
         }),
         .columns = 6,
         .rows = 6,
         .delta0 = 1,
         .delta = 1.5,
         .hint = always("the points of all cells together do not fill the square evenly")});
    return probe_check(name, points_of_cells(numbers, greatest), {inside, area, overlap, shape, even, purity()});
}

struct EdgePixel {
    int x, y;
    double covered;
};

std::vector<EdgePixel> edge_pixels(rt::ivec2 size, const Sight& seen) {
    std::vector<EdgePixel> edges;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            double covered = 0;
            for (int part = 0; part < 16; ++part) {
                const auto sight = [&](vec2 share) {
                    const vec2 film = vec2(x, y) + (vec2(part % 4, part / 4) + share) / 4.0;
                    return seen(film);
                };
                covered += over_pixel(0, 0, sight) / 16;
            }
            if (covered > 0.15 && covered < 0.85) edges.push_back({x, y, covered});
        }
    return edges;
}

/// Noise of N samples at the edges of a bright quad, over that of independent ones: N (L - p)^2 / (p (1 - p)), p the
/// share of the pixel that the quad covers.
Check edge_noise(Generator& random) {
    constexpr int samples = 16;
    const Place place = any_place(random);
    const rt::Quad q = any_quad(random, place, 0, 1);
    const std::string scene = toml(place.from_above(5, 40, figure_size)) + bright_lamp() + quad("lamp", q);
    const rt::Camera camera = camera_of(scene);
    const auto edges = later([=] { return edge_pixels(camera.size, sight_of(q, camera)); });
    const auto noise = [edges](const rt::Image& image) {
        double sum = 0;
        for (const EdgePixel& e : edges())
            sum += samples * rt::sqr(image.at(e.x, e.y).x - e.covered) / (e.covered * (1 - e.covered));
        return sum / double(edges().size());
    };
    return render_check(
        "edge_noise", {scene, samples, "stratified"},
        {of_picture(
            {.id = "G2",
             .what = "variance at edges, over that of independent samples",
             .number = noise,
             .truth = 0.2,
             .delta = 0.25,
             .delta0 = 0.1,
             .hint = with_value("the variance at edges is {:.2g} of that of independent samples; cells leave about 0.2 "
                                "with 16 samples: does each sample fall in a cell of its own, anywhere in it?")})});
}

}  // namespace

Checks check_stratified_2d(Generator& random) {
    const int side = whole_between(random, 3, 5), large = whole_between(random, 9, 12);
    const int some = whole_between(random, 26, 35), many = whole_between(random, 1100, 1400);
    const SamplesOfASquare samples{[](vec2, int i, int n, vec2 u) { return row(i, n, u); },
                                   of_result<vec2>([](vec2 p) { return SamplesOfASquare::Sample{p}; })};
    return {cells("grid_of_cells", {side * side, large * large}),
            cells("any_number_of_cells", {7, 11, 12, 13, some, many}),
            cells("two_cells", {2}),
            cells("three_cells", {3}),
            cells("five_cells", {5}, rt::below_one),
            edge_noise(random),
            error_orders(random, samples),
            rings(random, samples)};
}

}  // namespace grade
