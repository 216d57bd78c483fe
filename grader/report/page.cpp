#include "report/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "diagnosis/diagnosis.h"
#include "report/escape.h"
#include "report/folder.h"
#include "report/page_parts.h"
#include "report/picture.h"
#include "report/terminal.h"

namespace grade {

namespace {

std::string badge(Verdict verdict) {
    return fmt::format("<span class=\"badge {}\">{}</span>", name(verdict), in_words(verdict));
}

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

/// Yours, the right one, and the difference; without the right one, yours alone.
std::string three_pictures(const rt::Image& mine, const rt::Image& right, double exposure, const std::string& what) {
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
    return text + "</div>\n";
}

/// Where a picture differs beyond noise.
std::string tile_map(const CheckRecord& check) {
    if (check.tiles.empty()) return {};
    const Difference map = significance(check.tiles, check.picture.width, check.picture.height);
    const std::size_t clearest = check.tiles.clearest();
    return "<div class=\"pictures\">\n" +
           figure(
               data_uri(map.image, 1),
               "which tiles of the picture for " + check.name + " are surely darker or brighter",
               fmt::format("surely darker {0} surely brighter, not by chance. Most clearly, {1}"
                           "<details><summary>figures</summary>Tiles of {2} x {2} pixels; full colour where Welch's t "
                           "is beyond ±{3:g}; the clearest has t = {4:.3g}, p = {5:.2g}</details>",
                           scale, html(tile_in_words(check.tiles, clearest)), Tiles::side, map.full,
                           check.tiles.t[clearest], check.tiles.p[clearest]),
               "map") +
           "</div>\n";
}

/// The first answer along a path that is not the solution's.
std::string parting(const CheckRecord& check) {
    if (check.parting.empty()) return {};
    return "<details class=\"parting\"><summary>Where a path parts from the right one, with the same random numbers"
           "</summary><pre tabindex=\"0\">" +
           html(check.parting) + "</pre></details>\n";
}

std::string pictures(const CheckRecord& check) {
    if (!check.drawn.empty()) return check.drawn;
    if (check.picture.pixels.empty()) return {};
    // both alike, so that most of what is right can be seen
    const double exposure =
        preview_exposure(check.solution_picture.pixels.empty() ? check.picture : check.solution_picture);
    return three_pictures(check.picture, check.solution_picture, exposure, "for " + check.name) + tile_map(check) +
           parting(check);
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

/// What a page tells once, however many statistics say it.
using Told = std::set<std::string>;

std::string statistics(const CheckRecord& check, Told& told) {
    if (check.statistics.empty()) return {};
    std::string text =
        "<table class=\"statistics\"><tr><th>measures</th><th class=\"number\">yours</th><th class=\"number\">must "
        "be</th><th class=\"number\">right within</th><th class=\"number\">wrong beyond</th>"
        "<th><span class=\"legend dot\"></span>yours<span class=\"legend line\"></span>must be"
        "<span class=\"legend area\"></span>right<span class=\"legend faint\"></span>in between</th>"
        "<th>verdict</th></tr>\n";
    for (const StatisticRecord& s : check.statistics) text += statistic_row(s);
    text += "</table>\n";
    if (std::ranges::any_of(check.statistics, [](const auto& s) { return s.what.starts_with("chi squared"); }))
        text +=
            "<p class=\"soft\">Chi squared per degree of freedom is 1 where all is spread as chance spreads it, and "
            "more where it is not.</p>\n";
    for (const StatisticRecord& s : check.statistics)
        if (!s.hint.empty() && told.insert(s.hint).second)
            text += fmt::format("<p class=\"hint {}\">{}</p>\n", name(s.verdict), html_with_code(s.hint));
    return text;
}

std::string check_section(const CheckRecord& check, bool fragment_passes, Told& told) {
    const bool folded = check.verdict == Verdict::passed || is_not_run(check);
    std::string text = fmt::format("<details class=\"check{}\"{}><summary><h4>{}</h4>{}</summary>\n",
                                   folded ? "" : " is_open", folded ? "" : " open", html(check.name), badge(check));
    if (is_not_run(check))
        text += fmt::format("<p class=\"soft\">{}</p>\n", html(check.message));
    else if (!check.message.empty() && told.insert(check.message).second)
        text += fmt::format("<p class=\"hint {}\">{}</p>\n", name(check.verdict), html_with_code(check.message));
    if (!check.excerpt.empty())
        text += fmt::format("<p class=\"soft\">It printed:</p><pre tabindex=\"0\">{}</pre>\n", html(check.excerpt));
    const std::string found = pictures(check) + cost_line(check, fragment_passes) + statistics(check, told);
    text += found.empty() && !folded && check.excerpt.empty() ? "<p class=\"soft\">As said above.</p>\n" : found;
    if (!check.scene.empty())
        text += fmt::format(
            "<details><summary class=\"soft\">scene: <code>--samples {} --sampler {}</code></summary><pre "
            "tabindex=\"0\">{}</pre></details>\n",
            check.samples, html(check.sampler), html(check.scene));
    return text + "</details>\n";
}

/// The first line of the hint, and the line of code where the program breaks down.
std::string in_a_line(const FragmentRecord& fragment) {
    const std::string words = diagnose(fragment).words, fault = fragment.finding.fault;
    const std::string first = words.substr(0, words.find('\n'));
    return fault.empty() || first == fault ? first : first + "; " + fault;
}

/// Where to read about what is wrong.
std::string read_link(const std::string& section, const std::string& handout) {
    if (section.empty()) return {};
    if (handout.empty()) return "See " + html(reading(section));
    return fmt::format("See <a href=\"{}#{}\">handout, &quot;{}&quot;</a>", html(handout), html(anchor(section)),
                       html(section));
}

std::string fragment_section(const FragmentRecord& fragment, const std::string& handout) {
    std::string text = fmt::format(
        "<section class=\"card{4}\" id=\"{0}\"><div class=\"head\"><h3>{0}</h3>{1}<span class=\"points\"><b>{2:g}</b> "
        "of "
        "{3:g}</span></div>\n",
        html(fragment.name), badge(fragment.verdict), fragment.points, fragment.max_points,
        fragment.verdict == Verdict::passed ? " is_passed" : "");
    Told told;
    const auto tell = [&](const std::string& words) {
        std::istringstream lines(words);
        for (std::string line; std::getline(lines, line);) told.insert(line);
        return fmt::format("<p class=\"hint {}\">{}</p>\n", name(fragment.verdict), html_with_code(words));
    };
    if (fragment.verdict == Verdict::did_not_build)
        text += fmt::format("<pre tabindex=\"0\">{}</pre>\n", html(fragment.message));
    else if (!fragment.message.empty())
        text += tell(fragment.message);
    else if (const Finding& f = fragment.finding; !f.how.empty() || !f.arguments.empty() || !f.fault.empty())
        text += tell(diagnose(fragment).words);
    if (!fragment.finding.code.empty())
        text += fmt::format(
            "<details><summary class=\"soft\">this call as C++, and in a shell</summary><pre "
            "tabindex=\"0\">{}\n{}</pre></details>\n",
            html(fragment.finding.code), html(fragment.finding.command));
    if (!fragment.warnings.empty())
        text += fmt::format("<p class=\"soft\">The compiler warns:</p><pre tabindex=\"0\">{}</pre>\n",
                            html(fragment.warnings));
    if (const std::string link = read_link(diagnose(fragment).section, handout); !link.empty())
        text += fmt::format("<p class=\"soft\">{}</p>\n", link);
    if (fragment.verdict != Verdict::did_not_build && fragment.verdict != Verdict::not_started)
        for (const CheckRecord& check : fragment.checks)
            text += check_section(check, fragment.verdict == Verdict::passed, told);
    return text + "</section>\n";
}

/// A fragment's row: the verdict, the points, and the one hint.
std::string overview_row(const FragmentRecord& fragment, const std::string& handout) {
    const bool passed = fragment.verdict == Verdict::passed;
    const Diagnosis diagnosis = passed ? Diagnosis{} : diagnose(fragment);
    const std::string link = read_link(diagnosis.section, handout), words = passed ? "" : in_a_line(fragment);
    return fmt::format(
        "<tr{6} data-lost=\"{7:g}\"><td><a href=\"#{0}\">{0}</a></td><td>{1}</td><td class=\"number\">{2:g} of "
        "{3:g}</td>"
        "<td class=\"soft\">{4}{5}</td></tr>\n",
        html(fragment.name), badge(fragment.verdict), fragment.points, fragment.max_points, html_with_code(words),
        link.empty() ? "" : (words.ends_with('?') ? " " : ". ") + link, passed ? " class=\"is_passed\"" : "",
        fragment.max_points - fragment.points);
}

std::string overview(const Record& record, const std::string& handout) {
    std::string text =
        "<section class=\"card\" id=\"overview\"><div class=\"tools\">"
        "<button data-toggle=\"only\" aria-pressed=\"false\">only what is not passed</button>"
        "<button data-sort aria-pressed=\"false\">most points to be had first</button>"
        "<button data-toggle=\"open\" aria-pressed=\"false\">all details</button>"
        "<span class=\"soft\"><kbd>n</kbd> <kbd>p</kbd> next and previous that is not passed</span></div>\n"
        "<table class=\"overview\">\n";
    for (const Part& part : record.parts) {
        double have = 0, most = 0;
        std::string rows;
        for (const FragmentRecord& fragment : record.fragments) {
            if (fragment.part != part.name) continue;
            have += fragment.points, most += fragment.max_points;
            rows += overview_row(fragment, handout);
        }
        if (!rows.empty())
            text += fmt::format(
                "<tr class=\"part\"><td colspan=\"2\">{}</td><td class=\"number\">{:g} of {:g}</td><td></td></tr>\n{}",
                html(part.title), have, most, rows);
    }
    text += "</table>\n";
    if (std::ranges::any_of(record.fragments, [](const FragmentRecord& fragment) {
            return fragment.verdict == Verdict::failed && fragment.points > 0;
        }))
        text +=
            "<p class=\"soft\">Of a fragment that fails, each check that passes counts. A check that meets the mistake "
            "in some scenes alone may pass under another seed; a fragment's verdict is the same under all.</p>\n";
    return text + "</section>\n";
}

/// What to do first: the first fragment, in the order of the handout, that does not pass.
std::string next_step(const Record& record) {
    for (const FragmentRecord& fragment : record.fragments)
        if (fragment.verdict != Verdict::passed)
            return fmt::format("<p>Next: <a href=\"#{0}\">{0}</a>, {1}: {2}</p>", html(fragment.name),
                               in_words(fragment.verdict), html_with_code(in_a_line(fragment)));
    return "<p>All of it passes.</p>";
}

std::string own_picture(const Record& record) {
    if (!record.own_picture_fault.empty())
        return fmt::format(
            "<h2>Your own picture</h2><section class=\"card\"><p class=\"hint crashed\">No picture: "
            "{}</p></section>\n",
            html(record.own_picture_fault));
    if (record.own_picture.pixels.empty()) return {};
    const char* made_of = record.own_picture_of_some
                              ? "with the fragments that were graded, and right ones in place of the others"
                              : "with all of your fragments; blanks stand in for those that are missing or do "
                                "not build";
    return fmt::format(
        "<h2>Your own picture</h2><section class=\"card own\">{}<p class=\"soft\">{}, "
        "{}{}.</p></section>\n",
        three_pictures(record.own_picture, record.own_picture_right, record.own_picture_exposure,
                       "of " + record.own_picture_scene),
        html(record.own_picture_scene), made_of,
        record.left_out.empty()
            ? ""
            : html(fmt::format("; without {}, which crashed or did not end", fmt::join(record.left_out, ", "))));
}

/// What has changed since the last grading.
std::string notes(const Record& record) {
    std::string text;
    for (const std::string& note : record.notes)
        text += fmt::format("<section class=\"card\"><p>Note: {}</p></section>\n", html(note));
    return text;
}

std::string changes(const Record& record) {
    if (record.changes.empty()) return {};
    std::string items;
    for (const std::string& change : record.changes) items += fmt::format("<li>{}</li>", html(change));
    return fmt::format("<section class=\"card\"><p>Since the last run:</p><ul>{}</ul></section>\n", items);
}

/// "0.1.0, commit 1a2b3c4d5e6f"
std::string version_of(const Record& record) {
    const Provenance& made = record.provenance;
    return made.version + (made.commit.empty() ? "" : ", commit " + made.commit.substr(0, 12));
}

}  // namespace

std::map<std::string, std::string> picture_parts(const Record& record) {
    std::map<std::string, std::string> parts;
    for (const FragmentRecord& fragment : record.fragments)
        for (const CheckRecord& check : fragment.checks)
            if (std::string text = pictures(check); !text.empty())
                parts[fragment.name + "/" + check.name] = std::move(text);
    return parts;
}

std::string page(const Record& record, const std::string& handout) {
    const double share = record.max_score() > 0 ? record.score() / record.max_score() : 0;
    std::string text = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
        "content=\"width=device-width\">"
        "<title>{:g} of {:g}: {}</title><style>{}</style></head><body><a class=\"skip\" href=\"#overview\">to the "
        "verdicts</a><main>\n{}",
        record.score(), record.max_score(), html(record.submission), page_style, page_links);
    text += fmt::format(
        "<header><div><h1>{}</h1><p>{}</p>{}<p class=\"soft\">seed {}</p></div><div class=\"score\"><b>{:g}</b> "
        "<span>of {:g}</span>"
        "<div class=\"meter\" role=\"img\" aria-label=\"{:.0f} percent\"><i "
        "style=\"width:{:.1f}%\"></i></div></div></header>\n",
        html(record.title), html(record.submission), next_step(record), record.seed, record.score(), record.max_score(),
        100 * share, 100 * share);
    text += notes(record) + changes(record) + overview(record, handout) + own_picture(record);
    for (const Part& part : record.parts) {
        std::string sections;
        for (const FragmentRecord& fragment : record.fragments)
            if (fragment.part == part.name) sections += fragment_section(fragment, handout);
        if (!sections.empty()) text += fmt::format("<h2>{}</h2>\n{}", html(part.title), sections);
    }
    text += error_section(record);
    text += fmt::format(
        "<h2>About this grading</h2><section class=\"card soft\"><p>Again: <code>{}</code></p><p>Toolchain: {}. Grader "
        "{}. Sandbox: {}.</p>"
        "<p>The bar through a measured value is its 99.8 % "
        "interval.</p></section>\n</main><script>{}</script></body></html>\n",
        html(record.command), html(record.provenance.toolchain), html(version_of(record)), html(record.sandbox),
        page_script);
    return text;
}

}  // namespace grade
