#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "convergence/record.h"

namespace grade::convergence {

namespace {

using Json = nlohmann::ordered_json;

// NaN and infinity become null: JSON has neither.

Json ratio(const std::optional<Ratio>& r) {
    return r ? Json{{"value", r->value}, {"low", r->low}, {"high", r->high}} : Json(nullptr);
}

Json level_json(const Level& level) {
    const auto [low, high] = level.mse_interval();
    Json json{{"samples", level.samples},
              {"replicates", level.runs.size()},
              {"mse", level.mse()},
              {"mse_low", low},
              {"mse_high", high},
              {"rmse", std::sqrt(level.mse())},
              {"relative_mse", level.relative()},
              {"rays", level.rays()},
              {"cpu_seconds", level.seconds()},
              {"efficiency_per_cpu_seconds", level.efficiency()}};
    for (const Run& run : level.runs)
        json["runs"].push_back(
            {{"mse", run.mse}, {"relative_mse", run.relative}, {"rays", run.rays}, {"cpu_seconds", run.cpu_seconds}});
    return json;
}

Json curve_json(const Curve& curve, const SceneRecord& scene) {
    Json json{{"who", name(curve.who)}, {"sampler", curve.sampler}, {"expected_slope", expected_order(curve.sampler)}};
    json["slope"] = curve.fit.good ? Json{{"value", curve.fit.order}, {"low", curve.fit.low}, {"high", curve.fit.high}}
                                   : Json(nullptr);
    json["v"] = curve.fit.v;
    json["plateau_rmse"] = std::sqrt(curve.fit.plateau);
    if (curve.bias) {
        json["squared_bias"] = {{"value", curve.bias->value}, {"standard_error", curve.bias->se}};
        json["biased"] = curve.bias->is_positive();
    }
    for (std::size_t k = 0; k < independent_samples.size(); ++k)
        json[fmt::format("to_mse_of_{}_independent_samples_cpu_seconds", independent_samples[k])] =
            scene.errors[k] ? ratio(curve.seconds_for(*scene.errors[k])) : Json(nullptr);
    for (const Level& level : curve.levels) json["levels"].push_back(level_json(level));
    return json;
}

Json scene_json(const SceneRecord& scene) {
    Json json{{"name", scene.name},
              {"file", scene.file},
              {"width", scene.size.x},
              {"height", scene.size.y},
              {"reference", {{"samples_of_each_half", scene.reference_samples}, {"rmse", scene.reference_noise}}}};
    for (std::size_t k = 0; k < independent_samples.size(); ++k)
        json[fmt::format("mse_of_{}_independent_samples", independent_samples[k])] =
            scene.errors[k] ? Json(*scene.errors[k]) : Json(nullptr);
    if (!scene.fault.empty()) json["fault"] = scene.fault;
    json["biased"] = scene.biased() != nullptr;
    json["curves"] = Json::array();
    for (const Curve& curve : scene.curves) json["curves"].push_back(curve_json(curve, scene));
    for (const Comparison& c : scene.comparisons)
        json["submission_over_solution"].push_back({{"sampler", c.sampler},
                                                    {"mse_at_equal_cpu_seconds", ratio(c.mse_at_equal_time)},
                                                    {"cpu_seconds_at_mse_of_64", ratio(c.time_at_error[0])},
                                                    {"cpu_seconds_at_mse_of_1024", ratio(c.time_at_error[1])}});
    return json;
}

}  // namespace

std::string to_json(const ConvergenceRecord& record) {
    Json json{{"schema", "penumbra/convergence/v1"},
              {"submission", record.submission},
              {"note", record.note},
              {"biased", record.is_biased()}};
    json["scenes"] = Json::array();
    for (const SceneRecord& scene : record.scenes) json["scenes"].push_back(scene_json(scene));
    json["sandbox"] = record.sandbox;
    json["toolchain"] = record.toolchain;
    json["versions"] = record.version;
    json["command"] = record.command;
    // a submission's text may be no UTF-8
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_csv(const ConvergenceRecord& record) {
    std::string text =
        "scene,who,sampler,samples,replicates,mse,mse_low,mse_high,relative_mse,rays,cpu_seconds,efficiency\n";
    for (const SceneRecord& scene : record.scenes)
        for (const Curve& curve : scene.curves)
            for (const Level& level : curve.levels) {
                const auto [low, high] = level.mse_interval();
                text += fmt::format("{},{},{},{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.0f},{:.6g},{:.6g}\n", scene.name,
                                    name(curve.who), curve.sampler, level.samples, level.runs.size(), level.mse(), low,
                                    high, level.relative(), level.rays(), level.seconds(), level.efficiency());
            }
    return text;
}

}  // namespace grade::convergence
