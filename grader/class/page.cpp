#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>

#include "class/findings.h"
#include "class/report.h"
#include "convert/words.h"
#include "diagnosis/diagnosis.h"
#include "report/escape.h"
#include "report/page_parts.h"

namespace grade::course {

namespace {

constexpr std::size_t most_mistakes = 40, most_names = 12, most_twins = 50;

using Links = std::vector<std::string>;  // by result: its name, with a link where there is a page

Links links_of(const std::vector<Result>& results) {
    const std::vector<std::string> places = places_of(results);
    Links links;
    for (std::size_t i = 0; i < results.size(); ++i)
        links.push_back(results[i].record
                            ? fmt::format("<a href=\"{}.html\">{}</a>", html(places[i]), html(results[i].student.name))
                            : html(results[i].student.name));
    return links;
}

std::string names(const std::vector<std::size_t>& who, const Links& links) {
    std::string text;
    for (std::size_t i = 0; i < std::min(who.size(), most_names); ++i) text += (i ? ", " : "") + links[who[i]];
    if (who.size() > most_names) text += fmt::format(" and {} more", who.size() - most_names);
    return text;
}

/// How many have 0 to 10 %, ... of the points.
std::string spread_of_scores(const std::vector<Result>& results) {
    std::array<int, 10> counts{};
    int most = 1;
    for (const Result& result : results)
        if (result.record && result.record->max_score() > 0) {
            const double share = result.record->score() / result.record->max_score();
            most = std::max(most, ++counts[std::size_t(std::clamp(10 * share, 0.0, 9.0))]);
        }
    std::string text =
        "<div class=\"columns\" role=\"img\" aria-label=\"how many submissions have which share of the points\">";
    for (std::size_t i = 0; i < counts.size(); ++i)
        text += fmt::format("<div><span>{}</span><i style=\"height:{:.0f}%\"></i><span>{}</span></div>",
                            counts[i] ? std::to_string(counts[i]) : "", 75.0 * counts[i] / most, 10 * (i + 1));
    return text +
           "</div><p class=\"soft\">Above each bar, how many submissions have so large a part of the points; below it, "
           "up "
           "to which percent. The first bar is 0 to 10 %.</p>";
}

std::string by_fragment(const std::vector<Result>& results, const std::string& handout) {
    struct Sum {
        double points = 0, most = 0;
        int count = 0, passed = 0, idle = 0;
    };
    std::vector<std::string> order;
    std::map<std::string, Sum> sums;
    for (const Result& result : results) {
        if (!result.record) continue;
        for (const FragmentRecord& fragment : result.record->fragments) {
            if (!sums.contains(fragment.name)) order.push_back(fragment.name);
            Sum& sum = sums[fragment.name];
            sum.points += fragment.points, sum.most = fragment.max_points, ++sum.count;
            sum.passed += fragment.verdict == Verdict::passed, sum.idle += fragment.verdict == Verdict::not_started;
        }
    }
    std::string text =
        "<p class=\"soft\"><span class=\"entry\"><span class=\"key ok\"></span>passed</span> "
        "<span class=\"entry\"><span class=\"key no\"></span>wrong</span> "
        "<span class=\"entry\"><span class=\"key idle\"></span>not started</span></p><table "
        "class=\"overview\"><tr><th>fragment</th><th "
        "class=\"number\">mean</th><th>passed, wrong, not "
        "started</th><th class=\"number\">passed</th><th class=\"number\">wrong</th><th "
        "class=\"number\">not started</th></tr>\n";
    for (const std::string& name : order) {
        const Sum& s = sums[name];
        const int wrong = s.count - s.passed - s.idle;
        text += fmt::format(
            "<tr><td>{0}</td><td class=\"number\" data-is=\"mean\">{1} of {2}</td><td><div class=\"share\" "
            "role=\"img\" aria-label=\"{3} passed, {4} wrong, {5} not started\"><i class=\"ok\" "
            "style=\"width:{6:.1f}%\"></i><i class=\"no\" "
            "style=\"width:{7:.1f}%\"></i><i class=\"idle\" style=\"width:{8:.1f}%\"></i></div></td><td "
            "class=\"number\" data-is=\"passed\">{3}</td><td class=\"number\" data-is=\"wrong\">{4}</td><td "
            "class=\"number\" data-is=\"not started\">{5}</td></tr>\n",
            section_link(name, handout, html(name)), short_number(s.points / s.count), short_number(s.most), s.passed,
            wrong, s.idle, 100.0 * s.passed / s.count, 100.0 * wrong / s.count, 100.0 * s.idle / s.count);
    }
    return text + "</table>";
}

std::string frequent_mistakes(const std::vector<Result>& results, const Links& links) {
    const std::vector<Mistake> all = mistakes(results);
    if (all.empty()) return "<p>None.</p>";
    std::string text =
        "<table class=\"class\"><tr><th class=\"number\">how many</th><th>fragment</th><th>what is wrong, of the first "
        "of them</th><th>who</th></tr>\n";
    for (std::size_t i = 0; i < std::min(all.size(), most_mistakes); ++i)
        text += fmt::format(
            "<tr><td class=\"number\" data-is=\"how many\">{}</td><td "
            "data-is=\"fragment\"><code>{}</code></td><td>{}</td><td data-is=\"who\">{}</td></tr>\n",
            all[i].who.size(), html(all[i].fragment), html_with_code(all[i].hint.substr(0, 300)),
            names(all[i].who, links));
    text += "</table>";
    if (all.size() > most_mistakes)
        text += fmt::format("<p class=\"soft\">And {} more.</p>", all.size() - most_mistakes);
    return text;
}

std::string suspicious_twins(const std::vector<Result>& results, const Links& links) {
    const std::vector<Twins> all = twins(results);
    if (all.empty()) return "<p>None.</p>";
    std::string text =
        "<p class=\"soft\">Fragments that are the same but for comments, white space and names, and that at most three "
        "submissions share. A place to look, not a verdict.</p><table class=\"class\"><tr><th>who</th><th>"
        "fragments</th><th class=\"number\">tokens</th></tr>\n";
    for (std::size_t i = 0; i < std::min(all.size(), most_twins); ++i)
        text += fmt::format("<tr><td>{} and {}</td><td>{}</td><td class=\"number\" data-is=\"tokens\">{}</td></tr>\n",
                            links[all[i].a], links[all[i].b],
                            html(fmt::format("{}", fmt::join(all[i].fragments, ", "))), all[i].tokens);
    return text + "</table>";
}

std::string all_submissions(const std::vector<Result>& results, const Links& links) {
    std::string text = "<table class=\"class\"><tr><th>who</th><th class=\"number\">points</th><th>to know</th></tr>\n";
    for (std::size_t i = 0; i < results.size(); ++i) {
        const Result& result = results[i];
        std::vector<std::string> words;
        if (result.student.is_late) words.emplace_back("late");
        if (!result.fault.empty()) words.push_back(html(result.fault.substr(0, 400)));
        for (const std::string& note : result.notes) words.push_back(html(note.substr(0, 400)));
        text += fmt::format(
            "<tr><td>{}</td><td class=\"number\" data-is=\"points\">{}</td><td class=\"soft\">{}</td></tr>\n", links[i],
            result.record          ? short_number(result.record->score())
            : result.fault.empty() ? "not graded yet"
                                   : "none",
            fmt::join(words, "<br>"));
    }
    return text + "</table>";
}

struct Section {
    std::string title, body;
};

std::string shown(const Section& section) {
    return fmt::format("<h2 id=\"{}\">{}</h2><section class=\"card wide\">{}</section>\n", anchor(section.title),
                       section.title, section.body);
}

/// Links to all sections, and to the handout.
std::string index_of(const std::vector<Section>& sections, const std::string& handout) {
    std::string text = "<nav class=\"pages\" aria-label=\"sections of this page\">";
    for (const Section& section : sections)
        text += fmt::format("<a href=\"#{}\">{}</a>", anchor(section.title), section.title);
    return text + (handout.empty() ? "" : fmt::format("<a href=\"{}\">handout</a>", html(handout))) + "</nav>\n";
}

/// Of the first record: all are made with the same.
std::string made_with(const std::vector<Result>& results) {
    for (const Result& result : results)
        if (result.record) {
            const Record& r = *result.record;
            return fmt::format("seed {}; grader {} {}; {}", r.seed, r.provenance.version,
                               r.provenance.commit.substr(0, 12), r.sandbox);
        }
    return "nothing is graded yet";
}

}  // namespace

std::string class_page(const std::vector<Result>& results, const std::string& title, const std::string& handout) {
    const Links links = links_of(results);
    double sum = 0, most = 0;
    int count = 0;
    for (const Result& result : results)
        if (result.record) sum += result.record->score(), most = result.record->max_score(), ++count;
    const std::vector<Section> sections{{"Scores", spread_of_scores(results)},
                                        {"Submissions", all_submissions(results, links)},
                                        {"By fragment", by_fragment(results, handout)},
                                        {"Frequent mistakes", frequent_mistakes(results, links)},
                                        {"Twins", suspicious_twins(results, links)}};
    std::string text = page_head("Class: " + title, class_style);
    text += fmt::format(
        "<main>\n{}<header><div><h1>{}</h1><p>{}, {} graded</p><p class=\"soft\">{}</p></div><div "
        "class=\"score\"><b>{}</b> <span>of {}, mean</span></div></header>\n",
        index_of(sections, handout), html(title), counted(results.size()), count, html(made_with(results)),
        short_number(count ? sum / count : 0), short_number(most));
    for (const Section& section : sections) text += shown(section);
    text += "<p class=\"soft\">Tables: <a href=\"class.csv\">class.csv</a>";
    for (const auto& [system, file] : {std::pair("Canvas", "canvas.csv"), {"Moodle", "moodle.csv"}})
        if (has_any(results, system)) text += fmt::format(", <a href=\"{0}\">{0}</a>", file);
    return text + ".</p></main></body></html>\n";
}

}  // namespace grade::course
