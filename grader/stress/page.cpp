#include "stress/report.h"

#include <fmt/format.h>

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

std::string message_of(const FamilyRecord& f) {
    if (!f.started) return f.message.substr(0, f.message.find('\n'));
    for (const DecadeRecord& d : f.decades)
        if (!d.message.empty()) return fmt::format("at 1e{}: {}", d.decade, d.message);
    return {};
}

std::string overview(const StressRecord& record) {
    std::string text =
        "<section class=\"card\"><p class=\"soft\">Decades of what is swept, each row on its own scale."
        "<span class=\"key ordinary\"></span>ordinary scenes: scored<span class=\"key tried\"></span>tried"
        "<span class=\"key passes good\"></span>passes<span class=\"key passes bad\"></span>passes, but not all of "
        "what is scored"
        "<span class=\"key solution\"></span>the right one</p>\n<table class=\"overview\">\n"
        "<tr><th>family</th><th>scored tier</th><th>decades</th><th>passes</th><th>the right one</th></tr>\n";
    std::string about;
    for (const FamilyRecord& f : record.families) {
        if (f.family->fragments.front() != about)
            text += fmt::format("<tr class=\"part\"><td colspan=\"5\">{}</td></tr>\n",
                                html(about = f.family->fragments.front()));
        const std::string message = message_of(f);
        text += fmt::format(
            "<tr><td><a href=\"#{0}\">{0}</a><br><span class=\"soft\">{1}{2}</span></td><td>{3}</td><td>{4}</td>"
            "<td data-is=\"passes\">{5}</td><td data-is=\"the right one\">{6}</td></tr>\n",
            html(f.family->name), html(f.family->swept), message.empty() ? "" : "<br>" + html(message), badge(f),
            f.started ? reach_bar(f) : "", f.started ? html(in_words(f.reach)) : "", html(in_words(f.solution)));
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
        "decade over the one that is allowed there; triangles fail. The foot of a plot is 1e-8 and less, its head a "
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

std::string page(const StressRecord& record, const std::string& title) {
    const double share = record.most_scored() > 0 ? double(record.scored()) / record.most_scored() : 0;
    std::string text =
        page_head(fmt::format("{} of {}: {}", record.scored(), record.most_scored(), record.submission), stress_style) +
        "<main>\n" + page_links;
    text += fmt::format(
        "<header><div><h1>{}: stiff and extreme cases</h1><p>{}</p></div><div "
        "class=\"score\"><b>{}</b> <span>of {} families</span>"
        "<div class=\"meter\" role=\"img\" aria-label=\"{:.0f} percent\"><i style=\"width:{:.1f}%\"></i></div>"
        "<p class=\"soft\">bonus: {} decades beyond ordinary scenes; the right one {}</p></div></header>\n",
        html(title), html(record.submission), record.scored(), record.most_scored(), 100 * share, 100 * share,
        record.bonus(), record.most_bonus());
    text += overview(record) + counts(record) + plots(record);
    return text + fmt::format(
                      "<h2>About this run</h2><section class=\"card soft\"><p>Again: <code>{}</code></p><p>Toolchain: "
                      "{}. Grader {}. Sandbox: {}.</p></section>\n</main></body></html>\n",
                      html(record.command), html(record.toolchain), html(record.version), html(record.sandbox));
}

}  // namespace grade::stress
