#include "stress/report.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "diagnosis/diagnosis.h"
#include "report/escape.h"
#include "report/folder.h"
#include "report/page_parts.h"

namespace grade::stress {

namespace {

std::string badge(const FamilyRecord& f) {
    if (!f.started) return "<span class=\"badge not_started\">not run</span>";
    if (!f.is_scored()) return "<span class=\"soft\">bonus only</span>";
    return f.scored_passed() ? "<span class=\"badge passed\">passed</span>"
                             : "<span class=\"badge failed\">failed</span>";
}

/// Why it fails: what stopped it, or the failing decade of ordinary scenes that is nearest to the mildest one.
std::string why(const FamilyRecord& f) {
    if (!f.started) return f.message.substr(0, f.message.find('\n'));
    for (const DecadeRecord& d : f.decades)
        if (!d.message.empty()) return fmt::format("at 1e{}: {}", d.decade, d.message);
    if (!f.is_scored() || f.scored_passed()) return {};
    const Demand& demand = f.family->demand;
    const DecadeRecord* first = nullptr;
    for (const DecadeRecord& d : f.decades)
        if (demand.scored.holds(d.decade) && !d.passed &&
            (!first || std::abs(d.decade - demand.mildest()) < std::abs(first->decade - demand.mildest())))
            first = &d;
    if (!first) return {};
    if (!std::isfinite(first->error)) return fmt::format("at 1e{}: a wrong verdict or no number", first->decade);
    return fmt::format("at 1e{}: {} is {:.2g}, at most {:.2g} is allowed", first->decade, f.family->error, first->error,
                       demand.allowed(first->decade));
}

/// Where to read about a family that fails.
std::string reading_of(const FamilyRecord& f, const std::string& handout) {
    if (handout.empty() || !f.started || !f.is_scored() || f.scored_passed()) return {};
    const std::string numbers(numbers_section), own = f.family->fragments.front();
    return fmt::format("<br>Read {} and {}", section_link(own, handout, html(own)),
                       section_link(numbers, handout, html(numbers)));
}

std::string overview(const StressRecord& record, const std::string& handout) {
    std::string text =
        "<section class=\"card\"><p>Each row is a family of calls: one number, named below, is made more and more "
        "extreme, "
        "a power of ten at a time. A family passes where all of its ordinary scenes are right; what is right beyond "
        "them "
        "is a bonus.</p>\n<p class=\"soft\">Powers of ten, each row on its own scale: <span class=\"entry\"><span "
        "class=\"key ordinary\"></span>ordinary scenes</span> "
        "<span class=\"entry\"><span class=\"key tried\"></span>tried</span> "
        "<span class=\"entry\"><span class=\"key passes good\"></span>passes</span> "
        "<span class=\"entry\"><span class=\"key passes bad\"></span>passes, but not all that is ordinary</span> "
        "<span class=\"entry\"><span class=\"key solution\"></span>the right one</span></p>\n<table "
        "class=\"overview\">\n"
        "<tr><th>family</th><th>ordinary scenes</th><th>powers of ten</th><th>passes</th><th>the right one</th></tr>\n";
    std::string about;
    for (const FamilyRecord& f : record.families) {
        if (f.family->fragments.front() != about) {
            about = f.family->fragments.front();
            text += fmt::format("<tr class=\"part\"><td colspan=\"5\">{}</td></tr>\n",
                                section_link(about, handout, html(about)));
        }
        const std::string message = why(f);
        text += fmt::format(
            "<tr><td><a href=\"#{0}\">{0}</a><br><span class=\"soft\">{1}{2}{7}</span></td><td>{3}</td><td>{4}</td>"
            "<td data-is=\"passes\">{5}</td><td data-is=\"the right one\">{6}</td></tr>\n",
            html(f.family->name), html(f.family->swept), message.empty() ? "" : "<br>" + html(message), badge(f),
            f.started ? reach_bar(f) : "", f.started ? html(in_words(f.reach)) : "", html(in_words(f.solution)),
            reading_of(f, handout));
    }
    return text + "</table></section>\n";
}

std::string counts(const StressRecord& record) {
    if (record.counts.empty()) return {};
    std::string text =
        "<h2>Big counts</h2><section class=\"card\"><table><tr><th></th><th class=\"number\">calls</th><th "
        "class=\"number\">faults</th></tr>\n";
    for (const CountRecord& c : record.counts)
        text += fmt::format("<tr><td>{} {}</td><td class=\"number\">{:.3g}</td><td class=\"number\">{:.0f}</td></tr>\n",
                            html(c.what), html(c.message), c.calls, c.faults);
    return text + "</table></section>\n";
}

std::string plots(const StressRecord& record) {
    std::string text =
        "<h2>How the errors grow</h2><section class=\"card\"><p class=\"soft\">Each dot is the greatest error at that "
        "power of ten over the one that is allowed there; triangles fail. The foot of a plot is 1e-8 and less, its "
        "head a "
        "wrong verdict or no number. In the shade, the allowed error is what a picture forgives; outside, what double "
        "precision can do.</p><div class=\"plots\">\n";
    for (const FamilyRecord& f : record.families) {
        if (!f.started) continue;
        text += fmt::format("<figure id=\"{0}\"><figcaption><b>{0}</b><br>{1} by {2}</figcaption>{3}</figure>\n",
                            html(f.family->name), html(f.family->error), html(f.family->swept), error_plot(f));
    }
    return text + "</div></section>\n";
}

}  // namespace

std::string page(const StressRecord& record, const std::string& title, const std::string& handout) {
    const double share = record.most_scored() > 0 ? double(record.scored()) / record.most_scored() : 0;
    std::string text =
        page_head(fmt::format("{} of {}: {}", record.scored(), record.most_scored(), record.submission), stress_style) +
        "<main>\n" + page_links;
    text += fmt::format(
        "<header><div><h1>{}: stiff and extreme cases</h1><p>{}</p></div><div "
        "class=\"score\"><b>{}</b> <span>of {} families</span>"
        "<div class=\"meter\" role=\"img\" aria-label=\"{:.0f} percent\"><i style=\"width:{:.1f}%\"></i></div>"
        "<p class=\"soft\">bonus: {} powers of ten beyond ordinary scenes; the right one {}</p></div></header>\n",
        html(title), html(record.submission), record.scored(), record.most_scored(), 100 * share, 100 * share,
        record.bonus(), record.most_bonus());
    text += overview(record, handout) + counts(record) + plots(record);
    return text + fmt::format(
                      "<h2>About this run</h2><section class=\"card soft\"><p>Again: <code>{}</code></p><p>Toolchain: "
                      "{}. Grader {}. Sandbox: {}.</p></section>\n</main></body></html>\n",
                      html(record.command), html(record.toolchain), html(record.version), html(record.sandbox));
}

}  // namespace grade::stress
