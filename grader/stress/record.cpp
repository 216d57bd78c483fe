#include "stress/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace grade::stress {

namespace {

using Json = nlohmann::ordered_json;

int bonus_of(const Family& family, const Reach& reach) {
    return int(std::ranges::count_if(
        family.demand.decades, [&](int decade) { return reach.holds(decade) && !family.demand.scored.holds(decade); }));
}

/// JSON has no infinity.
Json number(double x) { return std::isfinite(x) ? Json(x) : Json("inf"); }

Json pair(const Decades& decades) { return decades.empty() ? Json(nullptr) : Json{decades.low, decades.high}; }

template <class Value>
int total(const std::vector<FamilyRecord>& families, Value value) {
    int sum = 0;
    for (const FamilyRecord& family : families) sum += int(value(family));
    return sum;
}

}  // namespace

int FamilyRecord::bonus() const { return bonus_of(*family, reach); }

int StressRecord::scored() const {
    return total(families, [](const FamilyRecord& f) { return f.scored_passed(); });
}
int StressRecord::most_scored() const {
    return total(families, [](const FamilyRecord& f) { return f.is_scored(); });
}
int StressRecord::bonus() const {
    return total(families, [](const FamilyRecord& f) { return f.bonus(); });
}
int StressRecord::most_bonus() const {
    return total(families, [](const FamilyRecord& f) { return bonus_of(*f.family, f.solution); });
}

Reach reach_of(const Family& family, const std::vector<DecadeRecord>& decades) {
    const auto start = std::ranges::find(decades, family.demand.mildest(), &DecadeRecord::decade);
    if (start == decades.end() || !start->passed) return {};
    auto low = start, high = start;
    while (low != decades.begin() && (low - 1)->passed) --low;
    while (high + 1 != decades.end() && (high + 1)->passed) ++high;
    return {low->decade, high->decade};
}

std::string in_words(const Reach& reach) {
    if (reach.empty()) return "none";
    if (reach.low == reach.high) return fmt::format("1e{}", reach.low);
    return fmt::format("1e{} to 1e{}", reach.low, reach.high);
}

std::string to_json(const StressRecord& record) {
    Json json{{"schema", "penumbra/stress/v1"}, {"submission", record.submission},
              {"scored", record.scored()},      {"max_scored", record.most_scored()},
              {"bonus", record.bonus()},        {"solution_bonus", record.most_bonus()}};
    for (const FamilyRecord& f : record.families) {
        Json family{{"name", f.family->name},
                    {"fragments", f.family->fragments},
                    {"swept", f.family->swept},
                    {"error", f.family->error},
                    {"tolerance", f.family->demand.tolerance},
                    {"bound", f.family->demand.bound},
                    {"scored_decades", pair(f.family->demand.scored)},
                    {"started", f.started},
                    {"reach", pair(f.reach)},
                    {"solution_reach", pair(f.solution)},
                    {"scored", f.is_scored() ? Json(f.scored_passed()) : Json(nullptr)},
                    {"bonus", f.bonus()}};
        if (!f.message.empty()) family["message"] = f.message;
        for (const DecadeRecord& d : f.decades) {
            Json decade{{"decade", d.decade}, {"error", number(d.error)}, {"passed", d.passed}};
            if (!d.message.empty()) decade["message"] = d.message;
            family["decades"].push_back(decade);
        }
        json["families"].push_back(family);
    }
    for (const CountRecord& c : record.counts)
        json["counts"].push_back({{"name", c.name},
                                  {"what", c.what},
                                  {"fragments", c.fragments},
                                  {"calls", c.calls},
                                  {"faults", c.faults},
                                  {"cpu_seconds", c.seconds},
                                  {"message", c.message}});
    json["cpu_seconds"] = record.cpu_seconds;
    json["sandbox"] = record.sandbox;
    json["toolchain"] = record.toolchain;
    json["versions"] = record.version;
    json["command"] = record.command;
    // what a submission printed need not be UTF-8
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace grade::stress
