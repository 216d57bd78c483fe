#include "report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "report/escape.h"

namespace grade {

namespace {

constexpr double width = 720, height = 440, left = 76, right = 190, top = 44, bottom = 56;

// Source: Okabe and Ito, "Color Universal Design", 2008.
constexpr std::array colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#000000"};

/// Whole decades about all values.
struct Axis {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

    void take(double value) {
        if (!(value > 0)) return;
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
                       html(words));
}

std::string power(double decade) {
    if (decade >= -3 && decade <= 4) return fmt::format("{:g}", std::pow(10, decade));
    return fmt::format("1e{:g}", decade);
}

}  // namespace

std::string log_log(const Plot& plot) {
    Axis x, y;
    for (const Series& series : plot.series)
        for (const auto& point : series.points)
            if (point.x > 0 && point.y > 0) x.take(point.x), y.take(point.y), y.take(point.low), y.take(point.high);
    x.close(), y.close();
    const double wide = width - left - right, tall = height - top - bottom;
    const auto at_x = [&](double value) { return left + wide * x.share(value); };
    const auto at_y = [&](double value) { return top + tall * (1 - std::clamp(y.share(value), 0.0, 1.0)); };

    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" "
        "role=\"img\" "
        "aria-label=\"{2}: {4} against {3}\" font-family=\"sans-serif\" font-size=\"13\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n",
        width, height, html(plot.title), html(plot.x), html(plot.y));
    svg += text(left, 24, "start", plot.title, "font-size=\"15\" font-weight=\"bold\"");
    for (double decade = x.low; decade <= x.high; ++decade) {
        const double at = at_x(std::pow(10, decade));
        svg += fmt::format("<path d=\"M{0:.1f} {1:g}V{2:g}\" stroke=\"#ddd\"/>\n", at, top, top + tall) +
               text(at, top + tall + 18, "middle", power(decade));
    }
    for (double decade = y.low; decade <= y.high; ++decade) {
        const double at = at_y(std::pow(10, decade));
        svg += fmt::format("<path d=\"M{0:g} {1:.1f}H{2:g}\" stroke=\"#ddd\"/>\n", left, at, left + wide) +
               text(left - 8, at + 4, "end", power(decade));
    }
    svg += text(left + wide / 2, height - 14, "middle", plot.x);
    svg += text(0, 0, "middle", plot.y, fmt::format("transform=\"translate(18 {:.1f}) rotate(-90)\"", top + tall / 2));

    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& series = plot.series[i];
        const char* color = colors[i % colors.size()];
        std::string line, upper, lower, dots;
        for (const auto& point : series.points) {
            if (!(point.x > 0 && point.y > 0)) continue;
            line += fmt::format("{}{:.1f} {:.1f}", line.empty() ? "M" : "L", at_x(point.x), at_y(point.y));
            if (!series.dashed)
                dots += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", at_x(point.x),
                                    at_y(point.y), color);
            if (point.high > point.low && point.low > 0) {
                upper += fmt::format("{:.1f},{:.1f} ", at_x(point.x), at_y(point.high));
                lower = fmt::format("{:.1f},{:.1f} ", at_x(point.x), at_y(point.low)) + lower;
            }
        }
        if (!upper.empty())
            svg += fmt::format("<polygon points=\"{}{}\" fill=\"{}\" opacity=\"0.18\"/>\n", upper, lower, color);
        svg += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"2\"{}/>\n", line, color,
                           series.dashed ? " stroke-dasharray=\"5 4\"" : "") +
               dots;
        const double row = top + 8 + 20 * double(i);
        svg += fmt::format("<path d=\"M{0:g} {1:g}h22\" stroke=\"{2}\" stroke-width=\"2\"{3}/>\n", left + wide + 14,
                           row, color, series.dashed ? " stroke-dasharray=\"5 4\"" : "");
        svg += text(left + wide + 42, row + 4, "start", series.name);
    }
    return svg + "</svg>\n";
}

}  // namespace grade
