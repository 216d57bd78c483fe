#pragma once

#include <string>
#include <vector>

namespace grade {

/// A line of a plot; what is 0 or less has no place on a logarithmic axis and is left out.
struct Series {
    struct Point {
        double x, y;
        double low = 0, high = 0;  // an interval of y, drawn as a ribbon where it is not empty
        std::string name{};        // below the pointer
    };
    std::string name;
    std::vector<Point> points;
    bool dashed = false;
    int color = -1;      // of the palette; -1: the series' place
    bool dots = true;    // on the points; a dashed line has none
    bool joined = true;  // by a line
};

/// A power law to compare with: a thin line of this slope.
struct Guide {
    double slope;
    std::string name;
};

/// Two points that belong together.
struct Pair {
    Series::Point from, to;
    std::string name;  // at `to`, where there is room; empty: none
};

struct Plot {
    std::string title, x, y;  // with units
    std::vector<Series> series;
    std::vector<Guide> guides{};  // from the upper left corner of what the series take
    double least_y = 0;           // above 0: what is below stands on it
    std::vector<Pair> pairs{};
};

/// A picture with logarithmic axes, as an SVG file of its own: no script, no font, colours that colour-blind readers
/// tell apart, dark on a dark page, an alternative text.
std::string log_log(const Plot& plot);

}  // namespace grade
