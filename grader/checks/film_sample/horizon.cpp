#include "checks/film_sample/checks.h"

#include <fmt/format.h>

#include "checks/kit/later.h"
#include "checks/kit/render_check.h"

namespace grade::film_sample {

namespace {

using rt::vec2, rt::vec3;

constexpr int columns = 64, rows = 24, cells = 4;

/// A floor of squares, seen from above it with the horizon level, a few rows above the picture.
struct Board {
    Place place;
    rt::Camera camera;
    vec2 start;     // of the squares, in the frame of the place
    double square;  // side of a square [m]

    /// In squares.
    vec2 at(vec2 film) const {
        const vec3 p = seen_on_plane(camera, film, place.origin, place.axes.z) - place.origin;
        return (vec2(rt::dot(p, place.axes.x), rt::dot(p, place.axes.y)) - start) / square;
    }
};

/// 1 in a square, -1 in the next.
double wave(double x) { return std::fmod(std::floor(x), 2) == 0 ? 1 : -1; }

/// The mean of the wave between two points.
double mean_wave(double low, double high) {
    const auto integral = [](double x) {
        const double within = x - 2 * std::floor(x / 2);
        return std::min(within, 2 - within);
    };
    return high == low ? wave(low) : (integral(high) - integral(low)) / (high - low);
}

/// What the light squares fill of each pixel, less a half, twice. A row of the film sees what is equally far away.
std::vector<double> covered(const Board& board) {
    constexpr int lines = 256;
    std::vector<double> means(std::size_t(columns) * rows, 0);
    for (int k = 0; k < rows * lines; ++k) {
        const double y = (k + 0.5) / lines;
        const vec2 left = board.at({0, y}), right = board.at({columns, y});
        for (int x = 0; x < columns; ++x) {
            const auto across = [&](int i) { return left.x + (right.x - left.x) * i / columns; };
            means[std::size_t(k / lines * columns + x)] += wave(left.y) * mean_wave(across(x), across(x + 1)) / lines;
        }
    }
    return means;
}

/// The same as the middles of a pixel's cells see it.
double seen_regularly(const Board& board, int x, int y) {
    return over_pixel(
        x, y,
        [&](vec2 film) {
            const vec2 p = board.at(film);
            return wave(p.x) * wave(p.y);
        },
        cells);
}

std::string text(const Board& board, double dark, double light) {
    const std::string checker = fmt::format("{{ albedo = {}, size = {} }}", dark, board.square);
    const double half = 1e5 * board.square;
    return material("board", {{"albedo", light}, {"checker", checker.c_str()}}) +
           directional_light(board.place.axes.z, rt::pi) +
           quad("board", board.place({board.start.x, board.start.y, 0}), half * board.place.axes.x,
                half * board.place.axes.y);
}

}  // namespace

Check horizon(Generator& random) {
    Board board{any_place(random), {}, {}, between(random, 0.5, 2)};
    const double height = board.square * between(random, 3, 6), far = 1000 * board.square;
    board.start = board.square * square(random);
    // the horizon is half of the picture and three rows above its middle
    const double focal = between(random, 150, 300), down = far * (rows / 2.0 + 3) / focal;
    const View view{board.place({0, 0, height}),
                    board.place({0, far, height - down}),
                    board.place.axes.z,
                    vfov_of(rows / 2.0, focal),
                    {columns, rows}};
    board.camera = camera_of(view);
    const double dark = between(random, 0.05, 0.2), light = between(random, 0.6, 0.9);
    const auto due = later([=] { return covered(board); });
    const auto pattern = later([=] {
        std::vector<double> all;
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x) all.push_back(seen_regularly(board, x, y) - due()[all.size()]);
        return all;
    });
    // how much of b there is in the picture, less what it must be
    const auto share = [=](const rt::Image& image, const std::vector<double>& b) {
        double sum = 0, whole = 0;
        for (std::size_t k = 0; k < b.size(); ++k) {
            const double seen = (2 * image.pixels[k].x - light - dark) / (light - dark);
            sum += (seen - due()[k]) * b[k], whole += b[k] * b[k];
        }
        return sum / whole;
    };
    return render_check(
        "horizon", {toml(view) + text(board, dark, light), cells * cells, "random"},
        {of_picture({.id = "A1",
                     .what = "contrast of a checkerboard's squares, over what a pixel's mean leaves of it",
                     .number = [=](const rt::Image& image) { return 1 + share(image, due()); },
                     .delta = 0.1,
                     .hint = with_value("a checkerboard's squares have {:.3g} of the contrast that a pixel's mean "
                                        "leaves: do samples fall beside their pixel, or in a part of it?")}),
         of_picture(
             {.id = "A2",
              .what = "false patterns of a checkerboard towards its horizon, over those that regular points see",
              .number = [=](const rt::Image& image) { return share(image, pattern()); },
              .truth = 0,
              .delta = 0.2,
              .hint = with_value(
                  "a checkerboard towards its horizon shows {:.2g} of the false patterns that a regular grid in each "
                  "pixel sees, however many pictures are averaged. Do samples fall everywhere in their cells?")})});
}

}  // namespace grade::film_sample
