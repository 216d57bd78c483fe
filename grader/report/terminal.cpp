#include "report/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <sstream>

#include "diagnosis/diagnosis.h"
#include "report/escape.h"

namespace grade {

namespace {

constexpr std::size_t line_width = 100;

const char* color_of_verdict(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return "\033[32m";
        case Verdict::not_started:
            return "\033[2m";
        case Verdict::inconclusive:
            return "\033[33m";
        default:
            return "\033[31m";
    }
}

/// Words in lines that are not too long, each after an indent. Lines of their own stay so.
std::string wrapped(const std::string& text, const std::string& indent, int most_lines) {
    std::string result;
    int count = 0;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && count < most_lines;) {
        if (line.find_first_not_of(' ') == line.npos) continue;
        const bool code = line.starts_with(' ');
        for (bool more = true; more && count < most_lines; ++count) {
            std::size_t cut = std::min(line.size(), line_width - indent.size());
            if (cut < line.size() && !code) {
                const std::size_t space = line.rfind(' ', cut);
                if (space != line.npos && space > 0) cut = space;
            }
            result += indent + line.substr(0, cut) + "\n";
            line.erase(0, code ? line.size() : cut + (cut < line.size()));
            more = !line.empty();
        }
    }
    return result;
}

std::string points_in_line(double x) { return fmt::format("{:g}", x); }

}  // namespace

std::string in_words(Verdict verdict) {
    std::string words(name(verdict));
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string fragment_rows(const Record& record, bool color) {
    const auto paint = [&](Verdict verdict, const std::string& text) {
        return color ? color_of_verdict(verdict) + text + "\033[0m" : text;
    };
    std::string rows;
    for (const FragmentRecord& fragment : record.fragments) {
        rows += fmt::format("  {:<24}{} {:>6} of {}\n", fragment.name,
                            paint(fragment.verdict, fmt::format("{:<16}", in_words(fragment.verdict))),
                            points_in_line(fragment.points), points_in_line(fragment.max_points));
        rows += wrapped(printable(fragment.warnings), "      ", 8);
        if (fragment.verdict == Verdict::passed) continue;
        const Diagnosis diagnosis = diagnose(fragment);
        const bool errors = fragment.verdict == Verdict::did_not_build;
        rows += wrapped(printable(diagnosis.words), "      ", 8);
        // what is blank or does not compile has its own words; the others say where to read
        if (!errors && fragment.verdict != Verdict::not_started && !diagnosis.section.empty())
            rows += "      " + reading(diagnosis.section) + "\n";
    }
    return rows;
}

std::string table(const Record& record, bool color) {
    std::string text;
    for (const Part& part : record.parts) {
        Record of_part;
        std::ranges::copy_if(record.fragments, std::back_inserter(of_part.fragments),
                             [&](const FragmentRecord& fragment) { return fragment.part == part.name; });
        if (of_part.fragments.empty()) continue;
        text += fmt::format("{}{:<43}{:>6} of {}{}\n{}\n", color ? "\033[1m" : "", part.title,
                            points_in_line(of_part.score()), points_in_line(of_part.max_score()),
                            color ? "\033[0m" : "", fragment_rows(of_part, color));
    }
    text += fmt::format("{}{:<43}{:>6} of {}{}\n", color ? "\033[1m" : "", "Total", points_in_line(record.score()),
                        points_in_line(record.max_score()), color ? "\033[0m" : "");
    for (const std::string& note : record.notes) text += "note: " + printable(note) + "\n";
    if (!record.changes.empty()) text += "Since the last run:\n";
    for (const std::string& change : record.changes) text += "  " + change + "\n";
    if (const auto ratio = record.efficiency_ratio())
        text += fmt::format("Efficiency of right pictures, 1/(MSE x CPU time): {:.2g} times the solution's (median)\n",
                            *ratio);
    return text;
}

ProgressLine::ProgressLine(bool long_work) : on_(isatty(STDERR_FILENO)), long_work_(long_work) {}

void ProgressLine::show(int done, int all, const std::string& doing) {
    const Clock::time_point now = Clock::now();
    const bool between = done > 0 && done < all;
    if (!on_ && !(long_work_ && between && now >= next_)) return;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    std::string left;
    if (between && (elapsed > 1 || !on_)) left = fmt::format(", about {:.0f} s left", elapsed * (all - done) / done);
    if (!on_) {
        next_ = now + std::chrono::seconds(10);
        fmt::print(stderr, "{} of {}{}\n", done, all, left);
        return;
    }
    fmt::print(stderr, "\r\033[K{:.0f} %{}  {}", all > 0 ? std::min(100.0, 100.0 * done / all) : 0, left,
               printable(doing, 60));
    std::fflush(stderr);
    shown_ = true;
}

void ProgressLine::clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
    shown_ = false;
}

}  // namespace grade
