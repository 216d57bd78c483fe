#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis.h"
#include "report/escape.h"
#include "report/page_parts.h"
#include "report/picture.h"
#include "report/terminal.h"

namespace grade {

namespace {

/// What no check has run for is not the fragment's: "not run" in place of the verdict that it shares.
std::string badge(const CheckRecord& check) {
    return is_not_run(check) ? "<span class=\"badge not_started\">not run</span>" : badge(check.verdict);
}

/// kind  "map": of differences, white where there is none
std::string figure(const std::string& source, const std::string& alt, const std::string& caption,
                   const char* kind = "") {
    return fmt::format("<figure{}><img loading=\"lazy\" src=\"{}\" alt=\"{}\"><figcaption>{}</figcaption></figure>\n",
                       *kind ? fmt::format(" class=\"{}\"", kind) : "", source, html(alt), caption);
}

constexpr const char* scale = "<span class=\"scale\" role=\"img\" aria-label=\"from blue to orange\"></span>";

std::string number_in_table(std::optional<double> x) {
    if (!x) return "unknown";
    return std::isfinite(*x) ? fmt::format("{:.4g}", *x) : std::isnan(*x) ? "no number" : "infinite";
}

/// Where a picture differs beyond noise.
std::string tile_map(const CheckRecord& check) {
    if (check.tiles.empty()) return {};
    const Difference map = significance(check.tiles, check.picture.width, check.picture.height);
    const std::size_t clearest = check.tiles.clearest();
    return figure(
        data_uri(map.image, 1), "which tiles of the picture for " + check.name + " are surely darker or brighter",
        fmt::format("surely darker {0} surely brighter, not by chance. Most clearly, {1}"
                    "<details><summary>figures</summary>Tiles of {2} x {2} pixels; full colour where Welch's t "
                    "is beyond ±{3:g}; the clearest has t = {4:.3g}, p = {5:.2g}</details>",
                    scale, html(tile_in_words(check.tiles, clearest)), Tiles::side, map.full, check.tiles.t[clearest],
                    check.tiles.p[clearest]),
        "map");
}

/// The first answer along a path that is not the solution's.
std::string parting(const CheckRecord& check) {
    if (check.parting.empty()) return {};
    return "<details class=\"parting\"><summary>Where a path parts from the right one, with the same random numbers"
           "</summary><pre tabindex=\"0\">" +
           html(check.parting) + "</pre></details>\n";
}

/// What the program left behind when it ended: the arguments of the call that went wrong, or what it printed.
std::string output(const CheckRecord& check) {
    if (check.excerpt.empty()) return {};
    const bool is_call = check.excerpt.starts_with("for (");
    return fmt::format("<p class=\"soft\">{}</p><pre tabindex=\"0\">{}</pre>\n",
                       is_call ? "All numbers that this call was given, in the order of the arguments:"
                               : "The program wrote on its output:",
                       html(is_call ? check.excerpt.substr(4) : check.excerpt));
}

/// A row, which narrow pages lay out as a block: data-is names what a header names on wide ones.
std::string statistic_row(const StatisticRecord& s) {
    const bool interval = s.low && s.high && *s.high > *s.low;
    const auto number = [](const char* is, const std::string& value) {
        return fmt::format("<td class=\"number\" data-is=\"{}\">{}</td>", is, value);
    };
    return fmt::format(
        "<tr><td><b>{}</b> {}{}</td>{}{}{}{}<td class=\"drawing\">{}</td><td class=\"verdict\">{}</td></tr>\n",
        html(s.id), html_with_code(s.what),
        s.replicates > 1 ? fmt::format("<br><span class=\"soft\">measured {} times</span>", s.replicates) : "",
        number("yours",
               number_in_table(s.value) + (interval ? fmt::format(" <span class=\"soft\">{} to {}</span>",
                                                                  number_in_table(s.low), number_in_table(s.high))
                                                    : "")),
        number("must be", number_in_table(s.truth)), number("right within", fmt::format("{:.3g}", right_within(s))),
        number("wrong beyond", fmt::format("{:.3g}", s.tolerance)), bar(s), badge(s.verdict));
}

std::string statistics(const CheckRecord& check, Told& told) {
    if (check.statistics.empty()) return {};
    std::string text =
        "<table class=\"statistics\"><tr><th>measures</th><th class=\"number\">yours</th><th class=\"number\">must "
        "be</th><th class=\"number\">right within</th><th class=\"number\">wrong beyond</th>"
        "<th><span class=\"entry\"><span class=\"legend dot\"></span>yours</span> "
        "<span class=\"entry\"><span class=\"legend line\"></span>must be</span> "
        "<span class=\"entry\"><span class=\"legend area\"></span>right</span> "
        "<span class=\"entry\"><span class=\"legend faint\"></span>in between</span></th>"
        "<th>verdict</th></tr>\n";
    for (const StatisticRecord& s : check.statistics) text += statistic_row(s);
    text += "</table>\n";
    if (std::ranges::any_of(check.statistics, &StatisticRecord::chi_squared))
        text +=
            "<p class=\"soft\">Chi squared per degree of freedom is 1 where all is spread as chance spreads it, and "
            "more where it is not.</p>\n";
    for (const StatisticRecord& s : check.statistics) {
        const bool is_in_row = s.value && s.truth && s.hint == in_numbers(s);
        if (!s.hint.empty() && !is_in_row && told.insert(s.hint).second)
            text += fmt::format("<p class=\"hint {}\">{}</p>\n", name(s.verdict), html_with_code(s.hint));
    }
    return text;
}

}  // namespace

std::string section_link(const std::string& section, const std::string& handout, const std::string& words) {
    if (handout.empty()) return words;
    return fmt::format("<a href=\"{}#{}\">{}</a>", html(handout), html(anchor(section)), words);
}

std::string read_link(const std::string& section, const std::string& handout) {
    if (section.empty()) return {};
    if (handout.empty()) return "See " + html(reading(section));
    return "See " + section_link(section, handout, fmt::format("handout, &quot;{}&quot;", html(section)));
}

std::string badge(Verdict verdict) {
    return fmt::format("<span class=\"badge {}\">{}</span>", name(verdict), in_words(verdict));
}

std::string three_pictures(const rt::Image& mine, const rt::Image& right, double exposure, const std::string& what,
                           const std::string& more) {
    std::string text = fmt::format("<div class=\"pictures\" data-exposure=\"{:.6g}\">\n", exposure);
    text += figure(data_uri(mine, exposure), "your picture " + what, "yours");
    if (!right.pixels.empty()) {
        text += figure(data_uri(right, exposure), "the right picture " + what, "the right one");
        const Difference map = difference(mine, right);
        text +=
            figure(data_uri(map.image, 1), "where your picture " + what + " is darker or brighter than the right one",
                   mine.pixels == right.pixels
                       ? "no difference"
                       : fmt::format("difference: darker {} brighter; full colour at ±{:.2g}", scale, map.full),
                   "map");
    }
    return text + more + "</div>\n";
}

std::string pictures(const CheckRecord& check) {
    if (!check.drawn.empty()) return check.drawn;
    if (check.picture.pixels.empty()) return {};
    // both alike, so that most of what is right can be seen
    const double exposure =
        preview_exposure(check.solution_picture.pixels.empty() ? check.picture : check.solution_picture);
    return three_pictures(check.picture, check.solution_picture, exposure, "for " + check.name, tile_map(check)) +
           parting(check);
}

std::string check_section(const CheckRecord& check, bool fragment_passes, Told& told) {
    const bool folded = check.verdict == Verdict::passed || is_not_run(check);
    std::string text = fmt::format("<details class=\"check\"{}><summary><h4>{}</h4>{}</summary>\n",
                                   folded ? "" : " open", html(check.name), badge(check));
    std::string found;
    if (is_not_run(check))
        found = fmt::format("<p class=\"soft\">{}</p>\n", html(check.message));
    else if (!check.message.empty() && told.insert(check.message).second)
        found = fmt::format("<p class=\"hint {}\">{}</p>\n", name(check.verdict), html_with_code(check.message));
    found += output(check) + pictures(check) + cost_line(check, fragment_passes) + statistics(check, told);
    text += found.empty() && !folded ? "<p class=\"soft\">As said above.</p>\n" : found;
    if (!check.scene.empty())
        text += fmt::format(
            "<details><summary class=\"soft\">scene: <code>--samples {} --sampler {}</code></summary><pre "
            "tabindex=\"0\">{}</pre></details>\n",
            check.samples, html(check.sampler), html(check.scene));
    return text + "</details>\n";
}

}  // namespace grade
