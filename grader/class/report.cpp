#include "class/report.h"

#include <fmt/format.h>

#include <cctype>
#include <set>

#include "convert/read_record.h"
#include "convert/tables.h"
#include "convert/words.h"
#include "files/files.h"
#include "report/escape.h"
#include "report/json.h"
#include "report/page.h"
#include "report/terminal.h"

namespace grade::course {

namespace {

/// A name that any file system takes, and any address: the letters of all languages, digits, and little else.
std::string safe_name(const std::string& name) {
    std::string safe;
    for (const char c : printable_line(name, 100)) {
        const auto byte = static_cast<unsigned char>(c);
        safe += std::isalnum(byte) || byte >= 0x80 || c == '-' || c == '.' ? c : '_';
    }
    return safe.empty() || safe.front() == '.' ? "_" + safe : safe;
}

std::vector<TableRow> rows_of(const std::vector<Result>& results) {
    std::vector<TableRow> rows;
    for (const Result& result : results)
        rows.push_back({result.student, result.record ? &*result.record : nullptr,
                        result.fault.empty() ? "not graded yet" : result.fault});
    return rows;
}

/// "; not read: hw1-ada.zip, hw1-bob" of those that are so; empty: none is.
std::string named(const char* what, const std::vector<Result>& results, bool (*is_so)(const Result&)) {
    constexpr std::size_t most = 20;
    std::string text;
    std::size_t count = 0;
    for (const Result& result : results)
        if (is_so(result) && ++count <= most) text += (count > 1 ? ", " : "") + printable_line(result.path, 100);
    if (count > most) text += fmt::format(" and {} more", count - most);
    return text.empty() ? text : fmt::format("; {}: {}", what, text);
}

/// Only what has changed: thousands of pages are not written again for one.
void write_changed(const fs::path& file, const std::string& text) {
    if (read_text(file, most_record_bytes) != text) write_text(file, text);
}

}  // namespace

std::vector<std::string> places_of(const std::vector<Result>& results) {
    std::vector<std::string> places;
    std::set<std::string> taken;
    for (const Result& result : results) {
        const std::string name = "submissions/" + safe_name(result.path);
        std::string place = name;
        for (int copy = 2; !taken.insert(place).second; ++copy) place = fmt::format("{}-{}", name, copy);
        places.push_back(place);
    }
    return places;
}

void write_class(const fs::path& out, const std::vector<Result>& results, const std::string& title,
                 const std::string& handout) {
    fs::create_directories(out / "submissions");
    const std::vector<std::string> places = places_of(results);
    for (std::size_t i = 0; i < results.size(); ++i) {
        if (!results[i].record) continue;
        write_changed(out / (places[i] + ".json"), to_json(*results[i].record));
        Record shown = *results[i].record;
        name_submission_in_calls(shown, "SUBMISSION");
        write_changed(out / (places[i] + ".html"), page(shown, ""));
    }
    const std::vector<TableRow> rows = rows_of(results);
    write_changed(out / "class.csv", csv_table(rows));
    for (const auto& [name, table] : {std::pair("canvas.csv", canvas_table(rows)), {"moodle.csv", moodle_table(rows)}})
        if (table.empty())
            fs::remove(out / name);
        else
            write_changed(out / name, table);
    write_changed(out / "index.html", class_page(results, title, handout));
    write_list(out, results, title);
}

std::string class_table(const std::vector<Result>& results) {
    std::string text;
    double sum = 0, most = 0;
    int count = 0;
    for (const Result& result : results) {
        std::string name = printable_line(result.student.name, 40);
        if (result.student.is_late) name += " (late)";
        if (result.record) {
            text += fmt::format("{:>7} of {:<5} {}\n", short_number(result.record->score()),
                                short_number(result.record->max_score()), name);
            sum += result.record->score(), most = result.record->max_score(), ++count;
        } else {
            text += fmt::format("{:>16} {}{}\n", result.fault.empty() ? "not graded yet" : "no points", name,
                                result.fault.empty() ? "" : ": " + printable_line(result.fault, 200));
        }
        for (const std::string& note : result.notes)
            text += fmt::format("{:17}note: {}\n", "", printable_line(note, 300));
    }
    text += fmt::format("{}, {} graded", counted(results.size()), count);
    if (count > 0) text += fmt::format("; mean {} of {}", short_number(sum / count), short_number(most));
    text += named("cannot be read", results, [](const Result& result) { return !result.fault.empty(); });
    text += named("not graded yet", results, is_open) + "\n";
    if (!has_any(results, "Canvas") && !has_any(results, "Moodle"))
        text += "No table for Canvas or Moodle: no name holds an ID of theirs. class.csv has the points.\n";
    return text;
}

}  // namespace grade::course
