#include "stress/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/escape.h"

namespace grade::stress {

namespace {

/// Where each decade of a family stands: side by side, at equal distances.
struct Places {
    const std::vector<int>& decades;
    double left, right;

    double step() const { return (right - left) / double(decades.size()); }
    double middle(std::size_t i) const { return left + (double(i) + 0.5) * step(); }
    double start(int decade) const {
        return left + step() * double(std::ranges::lower_bound(decades, decade) - decades.begin());
    }
    double end(int decade) const {
        return left + step() * double(std::ranges::upper_bound(decades, decade) - decades.begin());
    }
    std::string rect(const char* kind, const Decades& range, double y, double height) const {
        if (range.empty()) return {};
        return fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:g}\" width=\"{:.1f}\" height=\"{:g}\"/>", kind,
                           start(range.low), y, end(range.high) - start(range.low), height);
    }
};

std::string label(double x, double y, const char* anchor, const std::string& text) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:g}\" text-anchor=\"{}\">{}</text>", x, y, anchor, text);
}

std::string power(int decade) { return fmt::format("1e{}", decade); }

/// log10(error / allowed), as far as the plot goes; an error of 0 lies at its foot.
constexpr double foot = -8, head = 3;
double height_of(const Family& family, const DecadeRecord& d) {
    const double allowed = family.demand.allowed(d.decade);
    if (d.error == 0) return foot;
    if (!std::isfinite(d.error) || allowed == 0) return head;
    return std::clamp(std::log10(d.error / allowed), foot, head);
}

}  // namespace

std::string reach_bar(const FamilyRecord& f) {
    constexpr double width = 280, height = 30;
    const auto& decades = f.family->demand.decades;
    const Places at{decades, 40, width - 40};
    std::string svg = fmt::format(
        "<svg class=\"reach\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" role=\"img\" "
        "aria-label=\"{2}: passes {3}\">",
        width, height, html(f.family->swept), html(in_words(f.reach)));
    svg += at.rect("tried", {decades.front(), decades.back()}, 9, 10) +
           at.rect("ordinary", f.family->demand.scored, 2, 24);
    svg += at.rect(f.is_scored() && !f.scored_passed() ? "passes bad" : "passes good", f.reach, 9, 10);
    svg += at.rect("solution", f.solution, 22, 3);
    return svg + label(36, 18, "end", power(decades.front())) + label(width - 36, 18, "start", power(decades.back())) +
           "</svg>";
}

std::string error_plot(const FamilyRecord& f) {
    constexpr double width = 330, height = 150, top = 10, bottom = 124;
    const auto& decades = f.family->demand.decades;
    const Places at{decades, 40, width - 8};
    const auto y = [&](double v) { return bottom - (v - foot) / (head - foot) * (bottom - top); };
    std::string svg = fmt::format(
        "<svg class=\"errors\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" height=\"{1:g}\" role=\"img\" "
        "aria-label=\"{2}: error over the allowed one\">",
        width, height, html(f.family->name));
    svg += at.rect("ordinary", f.family->demand.scored, top, bottom - top);
    for (const double v : {-8.0, -4.0, 0.0}) {
        svg += fmt::format("<line class=\"{}\" x1=\"40\" x2=\"{:g}\" y1=\"{:.1f}\" y2=\"{:.1f}\"/>",
                           v == 0 ? "truth" : "axis", width - 8, y(v), y(v));
        svg += label(36, y(v) + 4, "end", v == 0 ? "1" : fmt::format("1e{:g}", v));
    }
    const std::size_t every = std::max<std::size_t>(1, (decades.size() + 5) / 6);
    for (std::size_t i = 0; i < decades.size(); i += every)
        svg += label(at.middle(i), 138, "middle", power(decades[i]));
    for (std::size_t i = 0; i < f.decades.size(); ++i) {
        const DecadeRecord& d = f.decades[i];
        const double x = at.middle(i), v = y(height_of(*f.family, d));
        // failures are triangles, so that shape tells as well as colour
        if (d.passed)
            svg += fmt::format("<circle class=\"dot good\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>", x, v);
        else
            svg += fmt::format("<path class=\"dot bad\" d=\"M{:.1f} {:.1f} l4 7 h-8 Z\"/>", x, v - 4);
    }
    return svg + "</svg>";
}

}  // namespace grade::stress
