#pragma once

#include <algorithm>

#include "checks/kit/check.h"
#include "checks/kit/draw.h"

namespace grade {

/// A check that calls its fragment.
inline Check probe_check(std::string name, std::function<Rows(Generator&)> inputs, std::vector<Statistic> statistics) {
    return {std::move(name), {}, Probe{{}, std::move(inputs)}, std::move(statistics)};
}

/// So many rows.
template <class F>
std::function<Rows(Generator&)> rows_of(int count, F draw) {
    return [count, draw](Generator& random) {
        Rows rows;
        for (int k = 0; k < count; ++k) rows.push_back(draw(random));
        return rows;
    };
}

/// So many rows of each kind: whatever the seed, each is there.
template <class... Draw>
std::function<Rows(Generator&)> rows_of_kinds(int each, Draw... draw) {
    return [=](Generator& random) {
        Rows rows;
        for (int k = 0; k < each; ++k) (rows.push_back(draw(random)), ...);
        return rows;
    };
}

/// The rows of one and then those of the other.
template <class First, class Second>
std::function<Rows(Generator&)> rows_then(First first, Second second) {
    return [=](Generator& random) {
        const Rows rows = first(random);
        return joined(rows, second(random));
    };
}

/// Rows with a number of each decade between two powers of ten.
template <class F>
std::function<Rows(Generator&)> rows_of_decades(int low, int high, int each, F row_with) {
    return [=](Generator& random) {
        Rows rows;
        for (int decade = low; decade < high; ++decade)
            for (int k = 0; k < each; ++k)
                rows.push_back(row_with(random, std::pow(10, decade + between(random, 0, 1))));
        return rows;
    };
}

/// Rows in which channels of one of so many colours are black, or full, in all ways that there are.
///
/// row_with(random, of, change)  `of`: which colour it is; change(color, c) is the colour c of that number, changed
template <class F>
std::function<Rows(Generator&)> rows_of_channels(int colors, F row_with) {
    return [=](Generator& random) {
        Rows rows;
        for (int of = 0; of < colors; ++of)
            for (unsigned which = 1; which < 8; ++which)
                for (const double value : {0.0, 1.0})
                    rows.push_back(row_with(random, of, [=](int color, rt::Color c) {
                        return color == of ? with_channels(c, which, value) : c;
                    }));
        return rows;
    };
}

/// side^2 rows in any order, whose numbers u lie one in each cell of a grid over the unit square: a mean over them has
/// the same expectation as over independent numbers, and much less noise.
template <class F>
std::function<Rows(Generator&)> rows_over_square(int side, F row_at) {
    return [side, row_at](Generator& random) {
        Rows rows;
        for (int k = 0; k < side * side; ++k) {
            const rt::vec2 cell(k % side, k / side), within = square(random);
            rows.push_back(row_at((cell + within) / double(side)));
        }
        std::ranges::shuffle(rows, random);  // so that a part of them is no part of the square
        return rows;
    };
}

}  // namespace grade
