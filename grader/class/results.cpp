#include "class/results.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "convert/read_record.h"
#include "files/files.h"
#include "files/sha256.h"
#include "judging/provenance.h"
#include "report/page.h"
#include "rt/files/scene_reader.h"

namespace grade::course {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* list_schema = "penumbra/class/v1";

Json result_json(const Result& result) {
    Json prints = Json::object();
    for (const auto& [fragment, print] : result.prints) prints[fragment] = {print.hash, print.tokens};
    return {{"name", result.student.name},    {"id", result.student.id}, {"system", result.student.system},
            {"late", result.student.is_late}, {"path", result.path},     {"fault", result.fault},
            {"notes", result.notes},          {"record", result.key},    {"fingerprints", prints}};
}

Result result_of(const Json& json) {
    Result result;
    result.student.name = json.at("name"), result.student.id = json.at("id");
    result.student.system = json.at("system"), result.student.is_late = json.at("late");
    result.path = json.at("path"), result.fault = json.at("fault");
    result.notes = json.at("notes").get<std::vector<std::string>>();
    result.key = json.at("record");
    for (const auto& [fragment, print] : json.at("fingerprints").items())
        result.prints[fragment] = {print.at(0), print.at(1)};
    return result;
}

}  // namespace

std::string counted(std::size_t submissions) {
    return fmt::format("{} submission{}", submissions, submissions == 1 ? "" : "s");
}

std::string key_of(const Submission& submission, const Assignment& assignment, const GradingSettings& settings) {
    std::string text = hash_of(submission.texts, assignment);
    // what could not be taken is told in the record
    for (const auto& [fragment, complaint] : submission.complaints)
        text += fmt::format("\n{}: {}", fragment, complaint);
    const Provenance& made = settings.provenance;
    text += fmt::format("\n{}\n{}\n{}\n{} {}\n{}", made.assignment, made.program, made.reference, settings.seed,
                        settings.time_limit, submission.folder);
    return sha256(text);
}

fs::path record_file(const fs::path& out, const std::string& key) { return out / "records" / (key + ".json"); }

fs::path pictures_file(const fs::path& out, const std::string& key) { return out / "records" / (key + ".pictures"); }

void write_pictures(const fs::path& out, const std::string& key, const Record& record) {
    write_text(pictures_file(out, key), Json(picture_parts(record)).dump() + "\n");
}

namespace {

void add_pictures(const fs::path& file, Record& record) {
    const auto text = read_text(file, most_record_bytes);
    const Json parts = text ? Json::parse(*text, nullptr, false) : Json();
    if (!parts.is_object()) return;
    for (FragmentRecord& fragment : record.fragments)
        for (CheckRecord& check : fragment.checks)
            if (const auto drawn = parts.find(fragment.name + "/" + check.name);
                drawn != parts.end() && drawn->is_string())
                check.drawn = *drawn;
}

}  // namespace

void write_list(const fs::path& out, const std::vector<Result>& results, const std::string& title) {
    Json json;
    json["schema"] = list_schema;
    json["title"] = title;
    json["results"] = Json::array();
    for (const Result& result : results) json["results"].push_back(result_json(result));
    write_text(out / "class.json", json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<Record> find_record(const fs::path& out, const Result& result) {
    if (result.key.empty()) return std::nullopt;
    const fs::path file = record_file(out, result.key);
    std::error_code error;
    if (!fs::exists(file, error)) return std::nullopt;
    try {
        Record record = read_record(file);
        if (!record.is_complete()) return std::nullopt;
        record.submission = result.path, record.notes = result.notes;
        record.student = result.student.name, record.student_id = result.student.id;
        add_pictures(pictures_file(out, result.key), record);
        return record;
    } catch (const rt::InputError&) {
        return std::nullopt;  // a broken file is as good as none
    }
}

std::vector<Result> read_list(const fs::path& out) {
    const fs::path file = out / "class.json";
    const auto text = read_text(file, most_record_bytes);
    const Json json = text ? Json::parse(*text, nullptr, false) : Json();
    if (!json.is_object() || json.value("schema", "") != list_schema)
        throw rt::InputError(
            fmt::format("{}: is no graded class; expected the folder that grade class has written", out.string()));
    std::vector<Result> results;
    try {
        for (const Json& entry : json.at("results")) results.push_back(result_of(entry));
    } catch (const nlohmann::json::exception& error) {
        throw rt::InputError(
            fmt::format("{}: {}; expected the file as grade class has written it", file.string(), error.what()));
    }
    for (Result& result : results) result.record = find_record(out, result);
    return results;
}

}  // namespace grade::course
