#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "convert/formats.h"
#include "convert/words.h"
#include "report/escape.h"

namespace grade {

namespace {

using Json = nlohmann::ordered_json;

/// "2.3": the third fragment of the second part.
std::string number_of(const Record& record, const FragmentRecord& fragment) {
    std::size_t part = 0, place = 0;
    while (part < record.parts.size() && record.parts[part].name != fragment.part) ++part;
    for (const FragmentRecord& other : record.fragments) {
        place += other.part == fragment.part;
        if (&other == &fragment) break;
    }
    return fmt::format("{}.{}", part + 1, place);
}

Json test_of(const Record& record, const FragmentRecord& fragment) {
    return {{"name", fragment.name},
            {"name_format", "text"},
            {"number", number_of(record, fragment)},
            {"score", fragment.points},
            {"max_score", fragment.max_points},
            {"status", fragment.verdict == Verdict::passed ? "passed" : "failed"},
            {"output", words_on(fragment)},
            {"output_format", "text"},
            {"tags", {fragment.part}},
            {"visibility", fragment.visibility}};
}

std::string summary(const Record& record) {
    std::string text = fmt::format("{}, seed {}\n", score_in_words(record), record.seed);
    for (const std::string& note : record.notes) text += "Note: " + printable_line(note) + "\n";
    if (std::ranges::any_of(record.fragments, [](const FragmentRecord& f) { return f.visibility != "visible"; }))
        text += "Some results are not shown yet; Gradescope shows no total as long as that is so.\n";
    return text;
}

}  // namespace

std::string gradescope(const Record& record) {
    const bool all_visible =
        std::ranges::all_of(record.fragments, [](const FragmentRecord& f) { return f.visibility == "visible"; });
    Json json;
    json["score"] = record.score();
    json["execution_time"] = record.wall_seconds;
    // the words hold the score, which a hidden result hides
    json["output"] = all_visible ? summary(record) : summary(record).substr(summary(record).find('\n') + 1);
    json["output_format"] = "text";
    json["visibility"] = "visible";
    json["stdout_visibility"] = "hidden";
    json["tests"] = Json::array();
    for (const FragmentRecord& fragment : record.fragments) json["tests"].push_back(test_of(record, fragment));
    json["extra_data"] = {{"seed", record.seed}, {"sha256", record.sha256}, {"commit", record.provenance.commit}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grade
