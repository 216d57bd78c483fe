#include "report/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "diagnosis/diagnosis.h"

namespace grade {

namespace {

using Json = nlohmann::ordered_json;

/// JSON has neither NaN nor infinity.
Json json_number(std::optional<double> x) { return x && std::isfinite(*x) ? Json(*x) : Json(nullptr); }

Json statistic_json(const CheckRecord& check, const StatisticRecord* statistic) {
    Json json;
    json["name"] = check.name;
    json["scene"] = check.scene;
    json["statistic"] = statistic ? Json(statistic->id) : Json(nullptr);
    if (statistic) {
        json["what"] = statistic->what;
        json["value"] = json_number(statistic->value);
        json["truth"] = json_number(statistic->truth);
        json["low"] = json_number(statistic->low);
        json["high"] = json_number(statistic->high);
        json["tolerance"] = json_number(statistic->tolerance);
        json["delta0"] = json_number(statistic->delta0);
        json["exact"] = statistic->exact;
        json["replicates"] = statistic->replicates;
    }
    json["verdict"] = name(statistic ? statistic->verdict : check.verdict);
    json["cause"] = statistic ? statistic->hint : check.message;
    json["hint"] = statistic ? statistic->hint : check.message;
    if ((statistic ? statistic->verdict : check.verdict) != Verdict::passed)
        json["read"] = reading(section_of(check, statistic));
    json["check_verdict"] = name(check.verdict);
    json["share"] = check.share;
    json["check_cpu_seconds"] = check.cpu_seconds;
    for (const auto& [whose, cost] : {std::pair("", check.cost), std::pair("solution_", check.solution_cost)}) {
        if (!cost) continue;
        json[std::string(whose) + "picture_rmse"] = json_number(cost->rmse());
        json[std::string(whose) + "picture_cpu_seconds"] = cost->cpu_seconds;
        json[std::string(whose) + "efficiency_per_cpu_seconds"] = json_number(cost->efficiency());
    }
    return json;
}

Json fragment_json(const FragmentRecord& fragment) {
    Json json;
    json["name"] = fragment.name;
    json["part"] = fragment.part;
    json["points"] = fragment.points;
    json["max_points"] = fragment.max_points;
    json["verdict"] = name(fragment.verdict);
    const Diagnosis diagnosis = diagnose(fragment);
    json["message"] = diagnosis.words;
    if (!diagnosis.section.empty()) json["read"] = reading(diagnosis.section);
    if (const Finding& finding = fragment.finding; !finding.arguments.empty()) {
        json["call"] = {{"arguments", finding.arguments}, {"answer", finding.answer}, {"right", finding.right}};
        if (!finding.code.empty()) json["call"]["code"] = finding.code;
        if (!finding.command.empty()) json["call"]["command"] = finding.command;
    }
    if (!fragment.warnings.empty()) json["warnings"] = fragment.warnings;
    json["cpu_seconds"] = fragment.cpu_seconds;
    json["checks"] = Json::array();
    for (const CheckRecord& check : fragment.checks) {
        if (check.statistics.empty()) json["checks"].push_back(statistic_json(check, nullptr));
        for (const StatisticRecord& statistic : check.statistics)
            json["checks"].push_back(statistic_json(check, &statistic));
    }
    return json;
}

}  // namespace

std::string to_json(const Record& record) {
    Json json;
    json["schema"] = "penumbra/result/v1";
    json["submission"] = record.submission;
    if (!record.notes.empty()) json["notes"] = record.notes;
    json["title"] = record.title;
    json["seed"] = record.seed;
    json["sandbox"] = record.sandbox;
    json["complete"] = !record.fragments.empty() && std::ranges::all_of(record.fragments, &FragmentRecord::finished);
    json["score"] = record.score();
    json["max_score"] = record.max_score();
    json["fragments"] = Json::array();
    for (const FragmentRecord& fragment : record.fragments) json["fragments"].push_back(fragment_json(fragment));
    json["toolchain"] = record.toolchain;
    json["versions"] = {{"grade", record.version}};
    json["command"] = record.command;
    json["efficiency_over_solution_by_cpu_seconds"] = json_number(record.efficiency_ratio());
    json["wall_seconds"] = record.wall_seconds;
    // a submission's text may be no UTF-8
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grade
