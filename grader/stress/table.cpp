#include "stress/report.h"

#include <fmt/format.h>

#include "report/escape.h"

namespace grade::stress {

std::string table(const StressRecord& record, bool color) {
    const auto paint = [&](const char* code, const std::string& text) {
        return color ? code + text + "\033[0m" : text;
    };
    std::string text = paint("\033[1m", fmt::format("{:<30}{:<47}{:<13}{:<17}{}\n", "family", "made extreme",
                                                    "ordinary", "passes", "right"));
    for (const FamilyRecord& f : record.families) {
        const std::string scored = !f.is_scored() ? "" : f.scored_passed() ? "passed" : f.started ? "failed" : "-";
        const char* code = !f.is_scored() || !f.started ? "\033[2m" : f.scored_passed() ? "\033[32m" : "\033[31m";
        text += fmt::format("{:<30}{:<47}{}{:<17}{}\n", f.family->name, f.family->swept,
                            paint(code, fmt::format("{:<13}", scored)), f.started ? in_words(f.reach) : "-",
                            in_words(f.solution));
        if (!f.started)
            text += fmt::format("    {}: {}\n", f.family->fragments.front(),
                                printable(f.message.substr(0, f.message.find('\n')), 90));
        for (const DecadeRecord& d : f.decades)
            if (!d.message.empty() && !d.passed) {
                text += fmt::format("    at 1e{}: {}\n", d.decade, printable(d.message, 90));
                break;
            }
    }
    for (const CountRecord& c : record.counts) {
        text += fmt::format("{:.3g} {}: {}{:.0f}{} ({:.0f} s)\n", c.calls, c.what,
                            color ? c.faults > 0 ? "\033[31m" : "\033[32m" : "", c.faults, color ? "\033[0m" : "",
                            c.seconds);
        if (!c.message.empty()) text += fmt::format("    {}\n", printable(c.message, 90));
    }
    text += fmt::format("\nOrdinary scenes: {} of {} families pass. Bonus: {} powers of ten beyond", record.scored(),
                        record.most_scored(), record.bonus());
    return text + fmt::format("; the right one {}.\n", record.most_bonus());
}

}  // namespace grade::stress
