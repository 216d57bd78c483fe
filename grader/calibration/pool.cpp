#include "calibration/pool.h"

#include <memory>
#include <nlohmann/json.hpp>

#include "protocol/bytes.h"
#include "files/files.h"
#include "judging/judge_check.h"

namespace grade {

namespace {

constexpr int most_faults = 8;
constexpr double patience_with_replicate = 10;  // CPU seconds of a replicate, as in a grading
constexpr std::uint64_t most_bytes = 1u << 30;

}  // namespace

Pool collect(const Check& check, std::uint64_t seed, int replicates, const fs::path& program,
             const fs::path& solution_program, const Sandbox& sandbox, const fs::path& meshes) {
    Pool pool;
    pool.statistics = int(check.statistics.size());
    Reference reference(check, seed, solution_program, sandbox, meshes);
    std::unique_ptr<Runner> runner;
    const auto next = [&](int replicate) -> std::optional<Observation> {
        if (!runner) runner = std::make_unique<Runner>(program, sandbox, meshes, patience_with_replicate);
        auto outcome = observe(*runner, check, replicate_seed(seed, check, Stream::submission, replicate));
        pool.cpu_seconds += runner->seconds();
        if (auto* observation = std::get_if<Observation>(&outcome)) return std::move(*observation);
        ++pool.faults;
        runner.reset();
        return std::nullopt;
    };

    const auto first = next(0);
    if (first) {
        const auto again = next(0), second = next(1);
        pool.unfit = again && unfit(check, *first, *again, reference);
        pool.ignores_seed = second && ignores_seed(check, *first, *second, reference);
    }
    pool.faults = 0, pool.cpu_seconds = 0;
    for (int k = 0; k < replicates && pool.faults < most_faults; ++k) {
        const auto observation = next(k);
        for (const Statistic& statistic : check.statistics)
            pool.scalars.push_back(observation ? measured(statistic, *observation)
                                               : std::numeric_limits<double>::quiet_NaN());
    }
    return pool;
}

void write_pool(const fs::path& path, const Pool& pool) {
    nlohmann::ordered_json head;
    head["schema"] = "penumbra/pool/v1";
    head["statistics"] = pool.statistics;
    head["replicates"] = pool.replicates();
    head["faults"] = pool.faults;
    head["unfit"] = pool.unfit;
    head["ignores_seed"] = pool.ignores_seed;
    head["cpu_seconds"] = pool.cpu_seconds;
    std::string text = head.dump() + "\n";
    text.append(reinterpret_cast<const char*>(pool.scalars.data()), pool.scalars.size() * sizeof(double));
    fs::create_directories(path.parent_path());
    write_text(path, text);
}

std::optional<Pool> read_pool(const fs::path& path) try {
    const auto text = read_text(path, most_bytes);
    if (!text) return std::nullopt;
    const std::size_t end = text->find('\n');
    const auto head = nlohmann::json::parse(text->substr(0, end));
    Pool pool;
    pool.statistics = head.at("statistics");
    pool.faults = head.at("faults");
    pool.unfit = head.at("unfit");
    pool.ignores_seed = head.at("ignores_seed");
    pool.cpu_seconds = head.at("cpu_seconds");
    pool.scalars.resize(head.at("replicates").get<std::size_t>() * std::size_t(pool.statistics));
    if (text->size() != end + 1 + pool.scalars.size() * sizeof(double)) return std::nullopt;
    copy_bytes(pool.scalars.data(), text->data() + end + 1, pool.scalars.size() * sizeof(double));
    return pool;
} catch (const nlohmann::json::exception&) {
    return std::nullopt;
}

}  // namespace grade
