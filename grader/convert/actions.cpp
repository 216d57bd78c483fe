#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "convert/formats.h"
#include "convert/words.h"
#include "diagnosis/diagnosis.h"
#include "report/escape.h"
#include "report/terminal.h"

namespace grade {

namespace {

constexpr std::size_t most_summary = 1'000'000, most_annotations = 10;

/// Text in a cell of a table: no HTML, no Markdown, one line.
std::string cell(const std::string& text) {
    std::string safe;
    for (const char c : html(text)) {
        if (c == '\n')
            safe += "<br>";
        else if (std::string_view("|\\`*_[]~@").find(c) != std::string_view::npos)
            safe += fmt::format("&#{};", int(c));
        else
            safe += c;
    }
    return safe;
}

/// What a workflow command takes for text.
std::string command_text(const std::string& text, bool is_property) {
    std::string safe;
    for (const char c : text) {
        const bool special = c == '%' || c == '\n' || c == '\r' || (is_property && (c == ':' || c == ','));
        safe += special ? fmt::format("%{:02X}", int(c)) : std::string(1, c);
    }
    return safe;
}

/// The line of the first error in "phong.cpp:12:5: error: ...", or that of a hint, "see line 12"; else the first one.
int line_of(const FragmentRecord& fragment, const std::string& words) {
    for (const std::string& start : {fragment.name + ".cpp:", std::string("line ")})
        for (std::size_t at = 0; (at = words.find(start, at)) != words.npos;) {
            at += start.size();
            int line = 0;
            for (std::size_t i = at; i < words.size() && words[i] >= '0' && words[i] <= '9' && line < 100'000; ++i)
                line = 10 * line + (words[i] - '0');
            if (line > 0) return line;
        }
    return 1;
}

/// As the repository has it, where the submission was a folder of it.
std::string file_in_repository(const Record& record, const FragmentRecord& fragment) {
    const std::string file = fragment.file.empty() ? fragment.name + ".cpp" : fragment.file;
    if (record.submission.empty() || record.submission.starts_with('/') || record.submission == ".") return file;
    std::string folder = record.submission;
    if (folder.starts_with("./")) folder.erase(0, 2);
    if (!folder.ends_with('/')) folder += '/';
    return folder + file;
}

std::string annotation(const Record& record, const FragmentRecord& fragment) {
    const std::string words = words_on(fragment);
    const bool is_blank = fragment.verdict == Verdict::not_started;
    return fmt::format("::{} file={},line={},title={}::{}\n", is_blank ? "notice" : "error",
                       command_text(printable_line(file_in_repository(record, fragment)), true),
                       line_of(fragment, words),
                       command_text(fmt::format("{}: {} of {} points", printable_line(fragment.name),
                                                short_number(fragment.points), short_number(fragment.max_points)),
                                    true),
                       command_text(words, false));
}

}  // namespace

std::string annotations(const Record& record) {
    std::vector<const FragmentRecord*> open;
    for (const FragmentRecord& fragment : record.fragments)
        if (fragment.verdict != Verdict::passed && fragment.visibility == "visible") open.push_back(&fragment);
    std::ranges::stable_sort(open, {}, [](const FragmentRecord* f) { return f->verdict == Verdict::not_started; });
    const std::size_t shown = open.size() > most_annotations ? most_annotations - 1 : open.size();
    std::string text;
    for (std::size_t i = 0; i < shown; ++i) text += annotation(record, *open[i]);
    if (open.size() > shown)
        text += fmt::format("::notice title={}::{} more fragments do not pass%3A the summary lists them\n",
                            command_text(score_in_words(record), true), open.size() - shown);
    return text;
}

std::string actions(const Record& record) {
    std::string text = fmt::format("## {}: {}\n\n", cell(record.title), score_in_words(record));
    for (const std::string& note : record.notes) text += "Note: " + cell(note) + "\n\n";
    const std::string end =
        fmt::format("\nSeed {}; {}; grader {}.\n", record.seed, cell(record.sandbox), cell(record.provenance.version));
    text += "| fragment | verdict | points | |\n|---|---|---:|---|\n";
    for (const FragmentRecord& fragment : record.fragments) {
        if (fragment.visibility != "visible") continue;
        const Diagnosis diagnosis = fragment.verdict == Verdict::passed ? Diagnosis{} : diagnose(fragment);
        const std::string row =
            fmt::format("| `{}` | {} | {} of {} | {} |\n", printable_line(fragment.name), in_words(fragment.verdict),
                        short_number(fragment.points), short_number(fragment.max_points), cell(diagnosis.words));
        if (text.size() + row.size() + end.size() + 100 > most_summary)
            text +=
                fmt::format("| `{}` | {} | {} of {} | |\n", printable_line(fragment.name), in_words(fragment.verdict),
                            short_number(fragment.points), short_number(fragment.max_points));
        else
            text += row;
    }
    return text + end;
}

}  // namespace grade
