#include "statistics/tiles.h"

#include <algorithm>
#include <cmath>

#include "statistics/tests.h"

namespace grade {

namespace {

double tile_luminance(const rt::Image& image, int column, int row) {
    double sum = 0;
    int count = 0;
    for (int y = row * Tiles::side; y < std::min((row + 1) * Tiles::side, image.height); ++y)
        for (int x = column * Tiles::side; x < std::min((column + 1) * Tiles::side, image.width); ++x, ++count) {
            const rt::Color c = image.at(x, y);
            sum += 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        }
    return sum / count;
}

}  // namespace

std::size_t Tiles::clearest() const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < t.size(); ++i)
        if (std::abs(t[i]) > std::abs(t[best]) ||
            (t[i] == t[best] && std::abs(mine[i] - right[i]) > std::abs(mine[best] - right[best])))
            best = i;
    return best;
}

Tiles compare_tiles(const std::vector<rt::Image>& mine, const std::vector<rt::Image>& right) {
    Tiles tiles;
    if (mine.empty() || right.empty() || mine[0].width != right[0].width || mine[0].height != right[0].height)
        return tiles;
    tiles.columns = (mine[0].width + Tiles::side - 1) / Tiles::side;
    tiles.rows = (mine[0].height + Tiles::side - 1) / Tiles::side;
    for (int row = 0; row < tiles.rows; ++row)
        for (int column = 0; column < tiles.columns; ++column) {
            Moments a, b;
            for (const rt::Image& image : mine) a.add(tile_luminance(image, column, row));
            for (const rt::Image& image : right) b.add(tile_luminance(image, column, row));
            const Welch test = welch_test(a, b);
            tiles.mine.push_back(a.mean), tiles.right.push_back(b.mean);
            tiles.t.push_back(test.t), tiles.p.push_back(test.p);
        }
    return tiles;
}

}  // namespace grade
