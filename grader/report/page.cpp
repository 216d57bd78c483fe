#include "report/page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "diagnosis/diagnosis.h"
#include "report/escape.h"
#include "report/folder.h"
#include "report/page_parts.h"
#include "report/terminal.h"

namespace grade {

namespace {

/// The first line of the hint, and the line of code where the program breaks down.
std::string in_a_line(const FragmentRecord& fragment) {
    const std::string words = diagnose(fragment).words, fault = fragment.finding.fault;
    const std::string first = words.substr(0, words.find('\n'));
    return fault.empty() || first == fault ? first : first + "; " + fault;
}

/// What is said of a fragment of which nothing is wrong.
std::string all_pass(const FragmentRecord& fragment) {
    const std::size_t checks = fragment.checks.size();
    return fmt::format("<p class=\"soft\">{}: nothing is wrong.</p>\n",
                       checks == 1 ? "Its check passes" : fmt::format("All of its {} checks pass", checks));
}

std::string fragment_section(const FragmentRecord& fragment, const std::string& handout) {
    std::string text = fmt::format(
        "<section class=\"card{4}\" id=\"{0}\"><div class=\"head\"><h3>{0}</h3>{1}<span class=\"points\"><b>{2:g}</b> "
        "of {3:g}</span></div>\n",
        html(fragment.name), badge(fragment.verdict), fragment.points, fragment.max_points,
        fragment.verdict == Verdict::passed ? " is_passed" : "");
    if (fragment.verdict == Verdict::passed) text += all_pass(fragment);
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
    else if (const Finding& f = fragment.finding;
             !f.how.empty() || !f.arguments.empty() || !f.fault.empty() || fragment.verdict == Verdict::timed_out)
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

/// A fragment's row: the verdict, the points, the one hint, and where to read.
std::string overview_row(const FragmentRecord& fragment, const std::string& handout) {
    const bool passed = fragment.verdict == Verdict::passed;
    const std::string section = passed ? fragment.name : diagnose(fragment).section;
    return fmt::format(
        "<tr{6} data-lost=\"{7:g}\"><td><a href=\"#{0}\">{0}</a></td><td>{1}</td><td class=\"number\">{2:g} of "
        "{3:g}</td>"
        "<td class=\"soft\">{4}</td>{5}</tr>\n",
        html(fragment.name), badge(fragment.verdict), fragment.points, fragment.max_points,
        passed ? "" : html_with_code(in_a_line(fragment)),
        handout.empty() ? ""
                        : fmt::format("<td class=\"soft read\" data-is=\"read\">{}</td>",
                                      section.empty() ? "" : section_link(section, handout, html(section))),
        passed ? " class=\"is_passed\"" : "", fragment.max_points - fragment.points);
}

std::string overview(const Record& record, const std::string& handout) {
    std::string text =
        "<section class=\"card\" id=\"overview\"><div class=\"tools\">"
        "<button data-toggle=\"only\" aria-pressed=\"false\">only what is not passed</button>"
        "<button data-sort aria-pressed=\"false\">most points to be had first</button>"
        "<button data-toggle=\"open\" aria-pressed=\"false\">all details</button>"
        "<span class=\"soft\"><kbd>n</kbd> <kbd>p</kbd> next and previous that is not passed</span></div>\n"
        "<table class=\"overview verdicts\"><thead><tr><th>fragment</th><th>verdict</th><th "
        "class=\"number\">points</th>"
        "<th>what is wrong</th>";
    text += handout.empty() ? "" : "<th class=\"read\">read in the handout</th>";
    text += "</tr></thead><tbody>\n";
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
                "<tr class=\"part\"><td colspan=\"2\">{}</td><td class=\"number\">{:g} of "
                "{:g}</td><td></td>{}</tr>\n{}",
                html(part.title), have, most, handout.empty() ? "" : "<td class=\"read\"></td>", rows);
    }
    text += "</tbody></table>\n";
    if (std::ranges::any_of(record.fragments, [](const FragmentRecord& fragment) {
            return fragment.verdict == Verdict::failed && fragment.points > 0;
        }))
        text +=
            "<p class=\"soft\">Of a fragment that fails, each check that passes counts. A check that meets the mistake "
            "in some scenes alone may pass under another seed; a fragment's verdict is the same under all.</p>\n";
    return text + "</section>\n";
}

/// What to do first: the first fragment, in the order of the handout, that is begun and does not pass; else one that is
/// not begun.
std::string next_step(const Record& record) {
    for (const bool is_blank : {false, true})
        for (const FragmentRecord& fragment : record.fragments) {
            if (fragment.verdict == Verdict::passed || is_blank != (fragment.verdict == Verdict::not_started)) continue;
            return fmt::format("<p>Next: <a href=\"#{0}\">{0}</a>, {1}: {2}</p>", html(fragment.name),
                               in_words(fragment.verdict), html_with_code(in_a_line(fragment)));
        }
    return "<p>All of it passes.</p>";
}

std::string own_picture(const Record& record) {
    if (!record.own_picture_fault.empty())
        return fmt::format(
            "<h2>Your own picture</h2><section class=\"card\"><p class=\"hint crashed\">No picture: {}</p></section>\n",
            html(record.own_picture_fault));
    if (record.own_picture.pixels.empty()) return {};
    const char* made_of = record.own_picture_of_some
                              ? "with the fragments that were graded, and right ones in place of the others"
                              : "with all of your fragments; blanks stand in for those that are missing or do "
                                "not build";
    return fmt::format(
        "<h2>Your own picture</h2><section class=\"card own\">{}<p class=\"soft\">{}, {}{}.</p></section>\n",
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

void name_submission_in_calls(Record& record, const std::string& submission) {
    for (FragmentRecord& fragment : record.fragments)
        if (std::string& command = fragment.finding.command; !command.empty()) command += " --of " + submission;
}

std::string page(const Record& record, const std::string& handout) {
    const double share = record.max_score() > 0 ? record.score() / record.max_score() : 0;
    std::string text =
        page_head(fmt::format("{:g} of {:g}: {}", record.score(), record.max_score(), record.submission)) +
        "<a class=\"skip\" href=\"#overview\">to the verdicts</a><main>\n" + page_links;
    text += fmt::format(
        "<header><div><h1>{}</h1><p>{}</p>{}<p class=\"soft\">seed {}</p></div><div class=\"score\"><b>{:g}</b> "
        "<span>of {:g}</span><div class=\"meter\" role=\"img\" aria-label=\"{:.0f} percent\"><i "
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
