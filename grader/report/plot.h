#pragma once

#include <string>
#include <vector>

namespace grade {

/// A line of a plot; what is 0 or less has no place on a logarithmic axis and is left out.
struct Series {
    struct Point {
        double x, y;
        double low = 0, high = 0;  // an interval of y, drawn as a ribbon where it is not empty
    };
    std::string name;
    std::vector<Point> points;
    bool dashed = false;
};

struct Plot {
    std::string title, x, y;  // with units
    std::vector<Series> series;
};

/// A picture with logarithmic axes, as an SVG file of its own: no script, no font, colours that colour-blind readers
/// tell apart, an alternative text.
std::string log_log(const Plot& plot);

}  // namespace grade
