#include "report/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "diagnosis/diagnosis.h"

namespace grade {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has neither NaN nor infinity.
Json json_number(std::optional<double> x) { return x && std::isfinite(*x) ? Json(*x) : Json(nullptr); }

/// Texts that are not empty.
void add_texts(Json& json, std::initializer_list<std::pair<const char*, std::string>> texts) {
    for (const auto& [key, text] : texts)
        if (!text.empty()) json[key] = text;
}

Json statistic_json(const CheckRecord& check, const StatisticRecord& statistic) {
    Json json;
    json["id"] = statistic.id;
    json["what"] = statistic.what;
    json["value"] = json_number(statistic.value);
    json["truth"] = json_number(statistic.truth);
    json["low"] = json_number(statistic.low);
    json["high"] = json_number(statistic.high);
    json["right_within"] = json_number(statistic.delta0);
    json["wrong_beyond"] = json_number(statistic.tolerance);
    json["exact"] = statistic.exact;
    json["replicates"] = statistic.replicates;
    if (statistic.chi_squared) json["chi_squared"] = true;
    json["verdict"] = name(statistic.verdict);
    add_texts(json, {{"hint", statistic.hint}});
    if (statistic.verdict != Verdict::passed) add_texts(json, {{"read", reading(section_of(check, &statistic))}});
    return json;
}

Json check_json(const CheckRecord& check) {
    Json json;
    json["name"] = check.name;
    json["points"] = check.points;
    json["max_points"] = check.max_points;
    json["verdict"] = name(check.verdict);
    add_texts(json, {{"message", check.message}});
    if (check.trouble != Trouble::none) json["trouble"] = name(check.trouble);
    if (check.statistics.empty() && check.verdict != Verdict::passed)
        add_texts(json, {{"read", reading(section_of(check, nullptr))}});
    json["cpu_seconds"] = check.cpu_seconds;
    if (!check.scene.empty()) {
        json["samples"] = check.samples;
        json["sampler"] = check.sampler;
        json["scene"] = check.scene;
    }
    for (const auto& [key, cost] : {std::pair("picture", check.cost), {"solution_picture", check.solution_cost}})
        if (cost) json[key] = {{"mse", json_number(cost->mse)}, {"cpu_seconds", cost->cpu_seconds}};
    json["statistics"] = Json::array();
    for (const StatisticRecord& statistic : check.statistics)
        json["statistics"].push_back(statistic_json(check, statistic));
    return json;
}

Json fragment_json(const FragmentRecord& fragment) {
    Json json;
    json["name"] = fragment.name;
    json["part"] = fragment.part;
    json["points"] = fragment.points;
    json["max_points"] = fragment.max_points;
    if (fragment.visibility != visibilities.front()) json["visibility"] = fragment.visibility;
    json["verdict"] = name(fragment.verdict);
    json["finished"] = fragment.finished;
    const Diagnosis diagnosis = diagnose(fragment);
    json["message"] = diagnosis.words;
    if (fragment.trouble != Trouble::none) json["trouble"] = name(fragment.trouble);
    add_texts(json, {{"read", reading(diagnosis.section)}, {"file", fragment.file}, {"sha256", fragment.sha256}});
    const Finding& finding = fragment.finding;
    if (!finding.how.empty() || !finding.where.empty() || !finding.arguments.empty()) {
        add_texts(json["finding"], {{"how", finding.how},
                                    {"where", finding.where},
                                    {"arguments", finding.arguments},
                                    {"answer", finding.answer},
                                    {"right", finding.right},
                                    {"code", finding.code},
                                    {"command", finding.command},
                                    {"fault", finding.fault}});
        json["finding"]["sampled"] = finding.sampled;
    }
    if (!fragment.warnings.empty()) json["warnings"] = fragment.warnings;
    json["cpu_seconds"] = fragment.cpu_seconds;
    json["checks"] = Json::array();
    for (const CheckRecord& check : fragment.checks) json["checks"].push_back(check_json(check));
    return json;
}

Json assignment_json(const Record& record) {
    Json parts = Json::array();
    for (const Part& part : record.parts) parts.push_back({{"name", part.name}, {"title", part.title}});
    return {{"title", record.title}, {"sha256", record.provenance.assignment}, {"parts", parts}};
}

Json grader_json(const Record& record) {
    const Provenance& made = record.provenance;
    return {{"version", made.version},
            {"commit", made.commit},
            {"program_sha256", made.program},
            {"reference_sha256", made.reference},
            {"checks_sha256", made.checks},
            {"toolchain", made.toolchain},
            {"flags", made.flags},
            {"built_for", made.built_for},
            {"processor", made.processor},
            {"sandbox", record.sandbox}};
}

}  // namespace

std::string to_json(const Record& record) {
    Json json;
    json["schema"] = record_schema;
    json["complete"] = record.is_complete();
    json["date"] = record.date;
    json["submission"] = {{"name", record.submission}, {"sha256", record.sha256}, {"notes", record.notes}};
    if (!record.student.empty()) json["submission"]["student"] = {{"name", record.student}, {"id", record.student_id}};
    json["assignment"] = assignment_json(record);
    json["grader"] = grader_json(record);
    json["command"] = record.command;
    json["seed"] = record.seed;
    json["selection"] = record.selection;
    json["limits"] = {{"time_limit", record.limits.time},
                      {"replicates", record.limits.replicates},
                      {"statistics", record.limits.statistics}};
    json["score"] = record.score();
    json["max_score"] = record.max_score();
    json["fragments"] = Json::array();
    for (const FragmentRecord& fragment : record.fragments) json["fragments"].push_back(fragment_json(fragment));
    json["wall_seconds"] = record.wall_seconds;
    // a submission's text may be no UTF-8
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string timeless_json(Record record) {
    record.date.clear(), record.wall_seconds = 0;
    for (FragmentRecord& fragment : record.fragments) {
        fragment.cpu_seconds = 0;
        for (CheckRecord& check : fragment.checks) {
            check.cpu_seconds = 0;
            for (auto* cost : {&check.cost, &check.solution_cost})
                if (*cost) (*cost)->cpu_seconds = 0;
        }
    }
    return to_json(record);
}

}  // namespace grade
