#include "report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/escape.h"

namespace grade {

namespace {

// Small, with the legend below: its words can be read where a narrow page scales it down. It is shown larger elsewhere.
constexpr double plot_width = 400, wide = 314, tall = 250, left = 58, top = 34, axis_room = 44, legend_row = 19;
constexpr double shown_larger = 1.3;

// Source: Okabe and Ito, "Color Universal Design", 2008.
constexpr std::array colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"};

/// What a dark page changes: the paper, the ink, and the series that its paper would swallow.
constexpr const char* dark_style =
    "<style>@media screen and (prefers-color-scheme:dark){.loglog .paper{fill:#1b212a}.loglog text{fill:#e6eaf0}"
    ".loglog .grid{stroke:#363f4c}.loglog .s0{color:#62b5ee}.loglog .s1{color:#ff9a57}.loglog .s2{color:#2cc79a}"
    ".loglog .s3{color:#e09cc4}.loglog .s4{color:#9adcf8}.loglog .s5{color:#e2c04a}.loglog .s6{color:#fff}}</style>\n";

/// Whole decades about all values.
struct Axis {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

    void take(double value) {
        if (!(value > 0) || !std::isfinite(value)) return;
        low = std::min(low, std::floor(std::log10(value)));
        high = std::max(high, std::ceil(std::log10(value)));
    }
    void close() {
        if (!(low <= high)) low = -1, high = 1;
        if (low == high) ++high;
    }
    double share(double value) const { return (std::log10(value) - low) / (high - low); }
};

std::string text(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y, anchor, more,
                       with_powers(html(words), "<tspan dy=\"-5\" font-size=\"9\">", "</tspan>"));
}

std::string power(double decade) {
    if (decade >= -2 && decade <= 4)  // as long as the others
        return fmt::format("{:g}", std::pow(10, decade));
    return fmt::format("1e{:g}", decade);
}

std::size_t color_of_series(const Series& series, std::size_t place) {
    return (series.color >= 0 ? std::size_t(series.color) : place) % colors.size();
}

/// Where the values of a plot are in its picture.
struct Frame {
    Axis x, y;
    double corner_x = std::numeric_limits<double>::infinity(), corner_y = 0;  // least x, greatest y

    explicit Frame(const Plot& plot) {
        for (const Series& series : plot.series)
            for (const auto& point : series.points) {
                if (!(point.x > 0 && point.y > 0)) continue;
                x.take(point.x);
                for (const double value : {point.y, point.low, point.high})
                    if (value > 0) y.take(std::max(value, plot.least_y));
                corner_x = std::min(corner_x, point.x), corner_y = std::max(corner_y, point.y);
            }
        x.close(), y.close();
    }
    double at_x(double value) const { return left + wide * x.share(value); }
    double at_y(double value) const { return top + tall * (1 - std::clamp(y.share(value), 0.0, 1.0)); }
};

struct Box {
    double left, right, top, bottom;

    bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
    bool holds(double x, double y) const { return left < x && x < right && top < y && y < bottom; }
};

/// Whether a curve passes through a box, or near by.
bool is_crossed(const Box& bare, const Plot& plot, const Frame& frame) {
    constexpr int steps = 64;  // of a line between two points
    constexpr double near = 2.5;
    const Box box{bare.left - near, bare.right + near, bare.top - near, bare.bottom + near};
    for (const Series& series : plot.series) {
        std::vector<std::pair<double, double>> places;
        for (const auto& point : series.points)
            if (point.x > 0 && point.y > 0) places.emplace_back(frame.at_x(point.x), frame.at_y(point.y));
        for (std::size_t i = 1; i < places.size(); ++i)
            for (int k = 0; k <= steps; ++k)
                if (box.holds(std::lerp(places[i - 1].first, places[i].first, double(k) / steps),
                              std::lerp(places[i - 1].second, places[i].second, double(k) / steps)))
                    return true;
    }
    return false;
}

/// The name of a guide that ends at x, y: behind the right border, or of one that ends at the foot beside its line, as
/// near to its end as there is neither a curve nor another name.
std::string guide_name(const Guide& guide, double x, double y, double slope, const Plot& plot, const Frame& frame,
                       std::vector<Box>& taken) {
    constexpr double length = 26, height = 12, gap = 3, step = 6;
    std::vector<Box> places;
    const auto add = [&](double from, double middle) {
        places.push_back({from, from + length, middle - height / 2, middle + height / 2});
    };
    if (x > left + wide - 1) add(x + gap, y);
    for (double back = 0; x - back > left + length; back += step) {
        const double beside = height / 2 + gap + std::abs(slope) * length / 2;
        add(x - back, y - slope * (back - length / 2) - beside);
        add(x - back - length, y - slope * (back + length / 2) + beside);
    }
    const auto is_free = [&](const Box& place) {
        const bool inside = place.top > top && place.bottom < top + tall && place.right < left + wide;
        return (inside || place.left > left + wide) && !is_crossed(place, plot, frame) &&
               std::ranges::none_of(taken, [&](const Box& other) { return other.meets(place); });
    };
    const auto free = std::ranges::find_if(places, is_free);
    if (free == places.end()) return {};
    taken.push_back(*free);
    return text(free->left, free->bottom - 2, "start", guide.name, "font-size=\"11\" fill=\"#666\"");
}

/// From the corner down to the border that is met first.
std::string guide_line(const Guide& guide, const Plot& plot, const Frame& frame, std::vector<Box>& taken) {
    if (!(frame.corner_y > 0)) return {};
    const double from_x = std::log10(frame.corner_x), from_y = std::log10(frame.corner_y);
    const double to_x = std::min(frame.x.high, from_x + (frame.y.low - from_y) / guide.slope);
    const double to_y = from_y + (to_x - from_x) * guide.slope;
    const double x = frame.at_x(std::pow(10, to_x)), y = frame.at_y(std::pow(10, to_y));
    const double begin_x = frame.at_x(frame.corner_x), begin_y = frame.at_y(frame.corner_y);
    return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#888\" stroke-dasharray=\"2 3\"/>\n", begin_x,
                       begin_y, x, y) +
           guide_name(guide, x, y, (y - begin_y) / (x - begin_x), plot, frame, taken);
}

std::string grid(const Frame& frame) {
    std::string svg;
    for (double decade = frame.x.low; decade <= frame.x.high; ++decade) {
        const double at = frame.at_x(std::pow(10, decade));
        svg += fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:g}V{2:g}\" stroke=\"#ddd\"/>\n", at, top, top + tall) +
               text(at, top + tall + 18, "middle", power(decade));
    }
    for (double decade = frame.y.low; decade <= frame.y.high; ++decade) {
        const double at = frame.at_y(std::pow(10, decade));
        svg +=
            fmt::format("<path class=\"grid\" d=\"M{0:g} {1:.1f}H{2:g}\" stroke=\"#ddd\"/>\n", left, at, left + wide) +
            text(left - 8, at + 4, "end", power(decade));
    }
    return svg;
}

/// How many series stand side by side in the legend.
std::size_t legend_columns(const Plot& plot) {
    constexpr std::size_t short_name = 20;
    return std::ranges::all_of(plot.series, [](const Series& s) { return s.name.size() <= short_name; }) ? 2 : 1;
}

std::string dot(double x, double y, const std::string& name = "") {
    const std::string title = name.empty() ? "" : "<title>" + html(name) + "</title>";
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"currentColor\">{}</circle>\n", x, y,
                       title);
}

/// The entry of a series in the legend: its line or dot, and its name.
std::string legend_entry(const Series& series, std::size_t place, std::size_t columns, const std::string& dashes) {
    const double row = top + tall + axis_room + 8 + legend_row * double(place / columns);
    const double at = left - 44 + (plot_width - 16) / double(columns) * double(place % columns);
    return (series.joined ? fmt::format("<path d=\"M{0:g} {1:g}h22\" stroke=\"currentColor\" stroke-width=\"2\"{2}/>\n",
                                        at, row, dashes)
                          : dot(at + 11, row)) +
           "</g>\n" + text(at + 28, row + 4, "start", series.name);
}

/// A series with its ribbon and its entry in the legend.
std::string drawn(const Series& series, std::size_t place, std::size_t columns, const Frame& frame) {
    const std::size_t color = color_of_series(series, place);
    const std::string dashes = series.dashed ? " stroke-dasharray=\"5 4\"" : "";
    std::string line, upper, lower, dots;
    for (const auto& point : series.points) {
        if (!(point.x > 0 && point.y > 0)) continue;
        const double x = frame.at_x(point.x), y = frame.at_y(point.y);
        line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", x, y);
        if (series.dots && !series.dashed) dots += dot(x, y, point.name);
        if (point.high > point.low && point.low > 0) {
            upper += fmt::format("{:.1f},{:.1f} ", x, frame.at_y(point.high));
            lower = fmt::format("{:.1f},{:.1f} ", x, frame.at_y(point.low)) + lower;
        }
    }
    std::string svg = fmt::format("<g class=\"s{}\" color=\"{}\">\n", color, colors[color]);
    if (!upper.empty())
        svg += fmt::format("<polygon points=\"{}{}\" fill=\"currentColor\" opacity=\"0.18\"/>\n", upper, lower);
    if (series.joined)
        svg +=
            fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"2\"{}/>\n", line, dashes);
    return svg + dots + legend_entry(series, place, columns, dashes);
}

/// A name beside its dot, on the first side where it covers neither a dot nor another name nor the frame.
std::string name_beside(double x, double y, const std::string& name, std::vector<Box>& taken) {
    constexpr double letter = 6, height = 12, gap = 7;
    const double length = letter * double(name.size());
    struct Side {
        const char* anchor;
        double x, y, from;  // from: the left end
    };
    const Side sides[] = {{"start", x + gap, y, x + gap},
                          {"end", x - gap, y, x - gap - length},
                          {"middle", x, y - gap - height / 2, x - length / 2},
                          {"middle", x, y + gap + height / 2, x - length / 2}};
    for (const Side& side : sides) {
        const Box box{side.from, side.from + length, side.y - height / 2, side.y + height / 2};
        const bool inside = box.left > left && box.right < left + wide && box.top > top && box.bottom < top + tall;
        if (!inside || std::ranges::any_of(taken, [&](const Box& other) { return box.meets(other); })) continue;
        taken.push_back(box);
        return text(side.x, side.y + 4, side.anchor, name, "font-size=\"11\"");
    }
    return {};  // the pointer still tells it
}

/// Lines between what belongs together, with as many names as there is room for.
std::string pairs(const std::vector<Pair>& all, const Frame& frame) {
    constexpr double around = 4;  // a dot
    std::vector<Box> taken;
    std::string svg;
    for (const Pair& pair : all) {
        for (const Series::Point* point : {&pair.from, &pair.to}) {
            const double x = frame.at_x(point->x), y = frame.at_y(point->y);
            taken.push_back({x - around, x + around, y - around, y + around});
        }
        svg += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#888\"/>\n", frame.at_x(pair.from.x),
                           frame.at_y(pair.from.y), frame.at_x(pair.to.x), frame.at_y(pair.to.y));
    }
    for (const Pair& pair : all)
        if (!pair.name.empty()) svg += name_beside(frame.at_x(pair.to.x), frame.at_y(pair.to.y), pair.name, taken);
    return svg;
}

}  // namespace

std::string log_log(const Plot& plot) {
    const Frame frame(plot);
    const std::size_t columns = legend_columns(plot), rows = (plot.series.size() + columns - 1) / columns;
    const double plot_height = top + tall + axis_room + legend_row * double(rows) + 4;
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"loglog\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{6:g}\" "
        "height=\"{7:g}\" role=\"img\" "
        "aria-label=\"{2}: {4} against {3}\" font-family=\"sans-serif\" font-size=\"13\">\n"
        "{5}<rect class=\"paper\" width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        plot_width, plot_height, html(plot.title), html(plot.x), html(plot.y), dark_style, shown_larger * plot_width,
        shown_larger * plot_height);
    svg += text(left, 20, "start", plot.title, "font-size=\"14\" font-weight=\"bold\"");
    svg += grid(frame);
    svg += text(left + wide / 2, top + tall + 36, "middle", plot.x);
    svg += text(0, 0, "middle", plot.y, fmt::format("transform=\"translate(14 {:.1f}) rotate(-90)\"", top + tall / 2));
    std::vector<Box> names;
    for (const Guide& guide : plot.guides) svg += guide_line(guide, plot, frame, names);
    svg += pairs(plot.pairs, frame);
    for (std::size_t i = 0; i < plot.series.size(); ++i) svg += drawn(plot.series[i], i, columns, frame);
    return svg + "</svg>\n";
}

}  // namespace grade
