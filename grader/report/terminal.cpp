#include "report/terminal.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <map>
#include <sstream>

#include "report/escape.h"

namespace grade {

namespace {

constexpr std::size_t line_width = 100, word_width = 64;  // word_width: of what stands in a row, behind its points
constexpr std::string_view below_row = "      ";
constexpr const char *bold = "\033[1m", *no_color = "\033[0m";

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

/// A call that is too long for a line has its answer, and the right one, in lines of their own.
std::string in_parts(std::string words, std::size_t most) {
    for (std::size_t begin = 0; begin < words.size();) {
        std::size_t end = std::min(words.find('\n', begin), words.size());
        if (end - begin > most && words.compare(begin, 4, "For ") == 0)
            for (const std::string_view before : {" the answer is ", " must be "})
                if (const std::size_t at = words.find(before, begin); at < end) words[at] = '\n', begin = at + 1;
        begin = end + 1;
    }
    return words;
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

bool is_told_by_itself(Verdict verdict) { return verdict == Verdict::not_started || verdict == Verdict::did_not_build; }

/// Words in which the fragment's file is named as it is from where their reader stands.
std::string with_folder(std::string words, const FragmentRecord& fragment, const Reader& reader) {
    const std::string& file = fragment.file;
    if (reader.folder.empty() || file.empty()) return words;
    for (std::size_t at = 0; (at = words.find(file, at)) != words.npos; at += file.size())
        if (at == 0 || std::string_view(" \n(").find(words[at - 1]) != std::string_view::npos)
            words.insert(at, reader.folder), at += reader.folder.size();
    return words;
}

std::string what_to_open(const FragmentRecord& fragment, const Reader& reader) {
    if (fragment.verdict == Verdict::passed || is_told_by_itself(fragment.verdict)) return {};
    return printable_line(with_folder(fragment.file, fragment, reader));
}

/// A line with the points in a column, and more in another.
std::string line_of(const std::string& first, double points, double most, const std::string& more) {
    const std::string column = fmt::format("{:>6g} of {:g}", points, most);
    return more.empty() ? first + column : fmt::format("{}{:<15}{}", first, column, more);
}

std::string line_of(const FragmentRecord& fragment, const std::string& more, bool color) {
    const std::string verdict = fmt::format("{:<14}", in_words(fragment.verdict));
    const std::string first = fmt::format("  {:<24}{} ", printable_line(fragment.name),
                                          color ? color_of_verdict(fragment.verdict) + verdict + no_color : verdict);
    return line_of(first, fragment.points, fragment.max_points, more) + "\n";
}

std::string sum_line(const std::string& what, const Record& of, const std::string& more, bool color) {
    const std::string line = line_of(fmt::format("{:<41}", printable_line(what)), of.score(), of.max_score(), more);
    return (color ? bold + line + no_color : line) + "\n";
}

}  // namespace

std::string in_words(Verdict verdict) {
    std::string words(name(verdict));
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string where_to_read(Verdict verdict, const Diagnosis& diagnosis) {
    return is_told_by_itself(verdict) ? "" : reading(diagnosis.section);
}

std::string verdicts_in_words(const Record& record) {
    std::map<Verdict, int> counts;
    for (const FragmentRecord& fragment : record.fragments) ++counts[fragment.verdict];
    std::vector<std::string> sums;
    for (const auto& [verdict, count] : counts) sums.push_back(fmt::format("{} {}", count, in_words(verdict)));
    return fmt::format("{}", fmt::join(sums, ", "));
}

std::string fragment_rows(const Record& record, const Reader& reader) {
    std::string rows;
    for (const FragmentRecord& fragment : record.fragments) {
        const Diagnosis diagnosis = fragment.verdict == Verdict::passed ? Diagnosis{} : diagnose(fragment);
        const std::string words = printable(with_folder(diagnosis.words, fragment, reader));
        const bool in_a_word =
            fragment.verdict == Verdict::not_started && words.size() < word_width && words.find('\n') == words.npos;
        rows += line_of(fragment, in_a_word ? words : what_to_open(fragment, reader), reader.color);
        if (!in_a_word) rows += wrapped(in_parts(words, line_width - below_row.size()), std::string(below_row), 10);
        if (reader.own && !fragment.finding.command.empty())  // in one piece, for a shell
            rows += fmt::format("{}again: {}\n", below_row, printable_line(fragment.finding.command));
        if (const std::string where = where_to_read(fragment.verdict, diagnosis); !where.empty())
            rows += fmt::format("{}read: {}\n", below_row, where);
        rows += wrapped(printable(with_folder(fragment.warnings, fragment, reader)), std::string(below_row), 8);
    }
    return rows;
}

std::string table(const Record& record, const Reader& reader) {
    std::vector<std::pair<std::string, Record>> parts;
    for (const Part& part : record.parts) {
        Record of_part;
        std::ranges::copy_if(record.fragments, std::back_inserter(of_part.fragments),
                             [&](const FragmentRecord& fragment) { return fragment.part == part.name; });
        if (!of_part.fragments.empty()) parts.emplace_back(part.title, std::move(of_part));
    }
    std::string text;
    for (const auto& [title, of_part] : parts)
        text += parts.size() == 1 ? fragment_rows(of_part, reader)
                                  : sum_line(title, of_part, "", reader.color) + fragment_rows(of_part, reader) + "\n";
    if (record.fragments.size() > 1) text += sum_line("Total", record, verdicts_in_words(record), reader.color);
    if (reader.own && std::ranges::any_of(record.fragments, [](const auto& f) { return !f.finding.command.empty(); }))
        text += "Fields that a call does not name have the defaults of starter/rt/parts.h and ray.h.\n";
    for (const std::string& note : record.notes) text += "note: " + printable_line(note) + "\n";
    if (!record.changes.empty()) text += "Since the last run:\n";
    for (const std::string& change : record.changes) text += "  " + printable_line(change) + "\n";
    // of a few it says nothing
    if (const auto ratio = record.efficiency_ratio(); ratio && record.selection.empty())
        text += fmt::format("Efficiency of right pictures, 1/(MSE x CPU time): {:.2g} times the solution's (median)\n",
                            *ratio);
    return text;
}

namespace {

std::string_view environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

/// One whose cursor moves.
bool is_terminal(int file) { return isatty(file) && environment("TERM") != "dumb"; }

}  // namespace

bool has_colors() {
    return is_terminal(STDOUT_FILENO) && environment("NO_COLOR").empty() && environment("CLICOLOR") != "0";
}

ProgressLine::ProgressLine(bool long_work) : on_(is_terminal(STDERR_FILENO)), long_work_(long_work) {}

void ProgressLine::show(int done, int all, const std::string& doing) {
    const Clock::time_point now = Clock::now();
    const bool between = done > 0 && done < all;
    if (!on_ && !(long_work_ && between && now >= next_)) return;
    const double elapsed = std::chrono::duration<double>(now - start_).count();
    std::string left;
    // what is done in the first moments are the quickest steps, which tell nothing of the others
    if (between && elapsed > 2) left = fmt::format(", about {:.0f} s left", std::ceil(elapsed * (all - done) / done));
    if (!on_) {
        next_ = now + std::chrono::seconds(10);
        fmt::print(stderr, "{} of {}{}\n", done, all, left);
        return;
    }
    fmt::print(stderr, "\r\033[K{:.0f} %{}  {}", all > 0 ? std::min(100.0, 100.0 * done / all) : 0, left,
               printable_line(doing, 60));
    std::fflush(stderr);
    shown_ = true;
}

void ProgressLine::clear() {
    if (shown_) fmt::print(stderr, "\r\033[K");
    shown_ = false;
}

}  // namespace grade
