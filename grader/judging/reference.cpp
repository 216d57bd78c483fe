#include "judging/reference.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "build/files.h"

namespace grade {

namespace {

std::vector<double> all_measured(const Check& check, const Observation& observation) {
    std::vector<double> values;
    for (const Statistic& statistic : check.statistics) values.push_back(measured(statistic, observation));
    return values;
}

}  // namespace

Observation Reference::Live::run(std::uint64_t with_seed) {
    constexpr double patience = 120;  // s
    if (!runner) runner = std::make_unique<Runner>(program, sandbox, meshes, patience);
    auto outcome = observe(*runner, check, with_seed);
    if (const Fault* fault = std::get_if<Fault>(&outcome))
        throw std::runtime_error(fmt::format("check {}: the solution itself: {}", check.name, fault->message));
    cpu_seconds = std::min(cpu_seconds, runner->seconds());
    return std::move(std::get<Observation>(outcome));
}

const Observation& Reference::Live::with_seed_of_submission(int which) {
    while (int(own.size()) <= which)
        own.push_back(run(replicate_seed(seed, check, Stream::submission, int(own.size()))));
    return own[std::size_t(which)];
}

Reference::Reference(const Check& check, std::uint64_t seed, const fs::path& program, const Sandbox& sandbox,
                     const fs::path& meshes)
    : live_(new Live{check, seed, program, sandbox, meshes, nullptr, {}}) {}

std::optional<std::vector<double>> Reference::exact() {
    if (live_) return all_measured(live_->check, live_->with_seed_of_submission(0));
    return stored_ ? std::optional(stored_->exact) : std::nullopt;
}

std::optional<std::vector<double>> Reference::replicate(int which) {
    if (live_)
        return all_measured(live_->check,
                            live_->run(replicate_seed(live_->seed, live_->check, Stream::reference, which)));
    if (!stored_ || which >= int(stored_->replicates.size())) return std::nullopt;
    return stored_->replicates[std::size_t(which)];
}

std::optional<bool> Reference::noisy() {
    if (live_) return differs(live_->with_seed_of_submission(0), live_->with_seed_of_submission(1));
    return stored_ ? std::optional(stored_->noisy) : std::nullopt;
}

std::optional<double> Reference::cpu_seconds() {
    if (live_) {
        live_->with_seed_of_submission(0);
        return live_->cpu_seconds;
    }
    return stored_ ? std::optional(stored_->cpu_seconds) : std::nullopt;
}

std::optional<rt::Image> Reference::image(int which) {
    if (!live_ || !std::holds_alternative<Render>(live_->check.experiment)) return std::nullopt;
    return live_->with_seed_of_submission(which).image;
}

std::optional<rt::Image> Reference::picture(int replicates) {
    if (!live_ || !std::holds_alternative<Render>(live_->check.experiment)) return std::nullopt;
    rt::Image mean = live_->with_seed_of_submission(0).image;
    for (int i = 1; i < replicates; ++i) {
        const rt::Image& next = live_->with_seed_of_submission(i).image;
        for (std::size_t k = 0; k < mean.pixels.size(); ++k)
            mean.pixels[k] += (next.pixels[k] - mean.pixels[k]) / double(i + 1);
    }
    return mean;
}

std::map<std::string, StoredCheck> read_references(const fs::path& folder) {
    std::map<std::string, StoredCheck> all;
    if (!fs::is_directory(folder)) return all;
    for (const auto& entry : fs::directory_iterator(folder)) {
        if (entry.path().extension() != ".json" || entry.path().stem() == "stress")
            continue;  // `grade stress` reads that one
        try {
            const auto json = nlohmann::json::parse(read_text(entry.path()).value_or(""));
            for (const auto& [name, check] : json.at("checks").items())
                all[entry.path().stem().string() + "." + name] = {check.at("exact"), check.at("replicates"),
                                                                  check.at("noisy"), check.at("cpu_seconds")};
        } catch (const nlohmann::json::exception& error) {
            throw std::runtime_error(
                fmt::format("{}: {}; expected what `grade references` writes", entry.path().string(), error.what()));
        }
    }
    return all;
}

void write_references(const fs::path& folder, const std::vector<Check>& checks,
                      const std::map<std::string, StoredCheck>& stored, std::uint64_t seed) {
    std::map<std::string, nlohmann::ordered_json> files;
    for (const Check& check : checks) {
        const auto found = stored.find(key_of(check));
        if (found == stored.end()) continue;
        const StoredCheck& values = found->second;
        auto& file = files[check.fragment];
        file["schema"] = "penumbra/reference/v1";
        file["seed"] = seed;
        auto& entry = file["checks"][check.name];
        for (const Statistic& statistic : check.statistics) entry["statistics"].push_back(statistic.id);
        entry["noisy"] = values.noisy;
        entry["cpu_seconds"] = values.cpu_seconds;
        entry["exact"] = values.exact;
        entry["replicates"] = values.replicates;
    }
    fs::create_directories(folder);
    for (const auto& [fragment, file] : files) write_text(folder / (fragment + ".json"), file.dump(1) + "\n");
}

}  // namespace grade
