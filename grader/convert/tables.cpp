#include "convert/tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "convert/formats.h"
#include "convert/words.h"
#include "report/escape.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

std::string line_of_csv(const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) line += (i ? "," : "") + cell_of_csv(cells[i]);
    return line + "\r\n";
}

/// The first record: all of a class have the same fragments.
const Record* first_of(const std::vector<TableRow>& rows) {
    for (const TableRow& row : rows)
        if (row.record) return row.record;
    return nullptr;
}

std::string points_or_none(const TableRow& row) { return row.record ? short_number(row.record->score()) : ""; }

/// Without its name where that is all that is said.
std::string own_words_on(const FragmentRecord& fragment) {
    if (fragment.trouble == Trouble::missing)
        return fmt::format("{}: not in the submission", in_words(fragment.verdict));
    const bool is_blank = fragment.verdict == Verdict::not_started && !fragment.file.empty();
    return is_blank ? in_words(fragment.verdict) : words_on(fragment);
}

/// What is to be said of each fragment; the same words of several once, where the first of them stands.
std::string feedback(const Record& record) {
    struct Same {
        std::string words;
        std::vector<std::string> names;
        double points = 0, most = 0;
    };
    std::vector<Same> all;
    for (const FragmentRecord& fragment : record.fragments) {
        if (fragment.verdict == Verdict::passed || fragment.visibility != "visible") continue;
        const std::string words = own_words_on(fragment);
        auto same = std::ranges::find(all, words, &Same::words);
        if (same == all.end()) same = all.insert(all.end(), Same{words});
        same->names.push_back(fragment.name);
        same->points += fragment.points, same->most += fragment.max_points;
    }
    std::string text = score_in_words(record);
    for (const Same& same : all) {
        const bool every = same.names.size() > 1 && same.names.size() == record.fragments.size();
        text +=
            fmt::format("\n{} {} of {}: {}", every ? "all fragments" : fmt::format("{}", fmt::join(same.names, ", ")),
                        short_number(same.points), short_number(same.most), same.words);
    }
    return text;
}

TableRow row_of(const Record& record) {
    Student student = student_of(std::filesystem::path(record.submission).filename().string());
    if (!record.student.empty()) student.name = record.student, student.id = record.student_id;
    return {student, &record, ""};
}

bool keep(std::vector<TableRow>& rows, const char* system) {
    std::erase_if(rows, [=](const TableRow& row) { return row.student.system != system; });
    return !rows.empty();
}

/// A table for a system, which must know the student.
std::string known(const std::string& table, const Record& record, const char* system, const char* example) {
    if (table.empty())
        throw rt::InputError(
            fmt::format("{}: the name holds no ID of {}'s, by which it takes grades; expected one such "
                        "as {}, or --to csv",
                        record.submission, system, example));
    return table;
}

}  // namespace

std::string cell_of_csv(const std::string& text) {
    std::string clean = printable(text, 20'000);
    if (clean.size() > 1 && std::string_view("=+-@\t\r\n|%").find(clean.front()) != std::string_view::npos)
        clean.insert(0, "'");
    if (clean.find_first_of(",\"\r\n;") == clean.npos) return clean;
    std::string quoted = "\"";
    for (const char c : clean) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string csv_table(const std::vector<TableRow>& rows) {
    std::vector<std::string> head{"student", "id", "late", "points", "of"};
    const Record* first = first_of(rows);
    if (first)
        for (const FragmentRecord& fragment : first->fragments) head.push_back(fragment.name);
    head.insert(head.end(), {"seed", "sha256", "notes", "submission"});
    std::string text = line_of_csv(head);
    for (const TableRow& row : rows) {
        std::vector<std::string> cells{row.student.name, row.student.id, row.student.is_late ? "late" : "",
                                       points_or_none(row), row.record ? short_number(row.record->max_score()) : ""};
        if (first)
            for (const FragmentRecord& wanted : first->fragments) {
                cells.emplace_back();
                if (row.record)
                    for (const FragmentRecord& fragment : row.record->fragments)
                        if (fragment.name == wanted.name) cells.back() = short_number(fragment.points);
            }
        cells.push_back(row.record ? fmt::format("{}", row.record->seed) : "");
        cells.push_back(row.record ? row.record->sha256 : "");
        cells.push_back(row.record ? fmt::format("{}", fmt::join(row.record->notes, "; ")) : row.fault);
        cells.push_back(row.record ? row.record->submission : "");
        text += line_of_csv(cells);
    }
    return text;
}

std::string canvas_table(std::vector<TableRow> rows) {
    if (!keep(rows, "Canvas")) return {};
    const Record* first = first_of(rows);
    std::string text =
        line_of_csv({"Student", "ID", "SIS User ID", "SIS Login ID", "Section", first ? first->title : "points"});
    if (first) text += line_of_csv({"    Points Possible", "", "", "", "", short_number(first->max_score())});
    for (const TableRow& row : rows)
        text += line_of_csv({row.student.name, row.student.id, "", "", "", points_or_none(row)});
    return text;
}

std::string moodle_table(std::vector<TableRow> rows) {
    if (!keep(rows, "Moodle")) return {};
    std::string text =
        line_of_csv({"Identifier", "Full name", "Status", "Grade", "Maximum Grade", "Grade can be changed",
                     "Last modified (submission)", "Last modified (grade)", "Feedback comments"});
    for (const TableRow& row : rows)
        text += line_of_csv({"Participant " + row.student.id, row.student.name, "Submitted for grading",
                             points_or_none(row), row.record ? short_number(row.record->max_score()) : "", "Yes", "-",
                             "-", html(row.record ? feedback(*row.record) : row.fault)});
    return text;
}

std::string csv(const Record& record) { return csv_table({row_of(record)}); }

std::string canvas(const Record& record) {
    return known(canvas_table({row_of(record)}), record, "Canvas", "doejane_12345_67890_work.zip");
}

std::string moodle(const Record& record) {
    return known(moodle_table({row_of(record)}), record, "Moodle", "'Jane Doe_12345_assignsubmission_file_'");
}

}  // namespace grade
