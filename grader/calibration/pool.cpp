#include "calibration/pool.h"

#include <memory>

#include "judging/run_check.h"
#include "programs/kept_file.h"

namespace grade::calibration {

namespace {

constexpr double patience_with_replicate = 10;  // CPU seconds of a replicate, as in a grading

}  // namespace

Pool collect(const Check& check, std::uint64_t seed, int replicates, const fs::path& program,
             const fs::path& solution_program, const Sandbox& sandbox, const fs::path& meshes, Pool pool) {
    pool.statistics = int(check.statistics.size());
    SolutionRunners solutions(solution_program, sandbox, meshes);
    Reference reference(check, seed, solutions);
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

    if (pool.replicates() == 0) {
        if (const auto first = next(0)) {
            const auto again = next(0), second = next(1);
            pool.unfit = again && unfit(check, *first, *again, reference);
            pool.ignores_seed = second && ignores_seed(check, *first, *second, reference);
        }
        pool.faults = 0, pool.cpu_seconds = 0;
    }
    for (int k = pool.replicates(); k < replicates && pool.faults < most_faults; ++k) {
        const auto observation = next(k);
        for (const Statistic& statistic : check.statistics)
            pool.scalars.push_back(observation ? measured(statistic, *observation)
                                               : std::numeric_limits<double>::quiet_NaN());
    }
    return pool;
}

void write_pool(const fs::path& path, const Pool& pool) {
    write_kept(path, {{"statistics", pool.statistics},
                      {"faults", pool.faults},
                      {"unfit", pool.unfit},
                      {"ignores_seed", pool.ignores_seed},
                      {"cpu_seconds", pool.cpu_seconds},
                      {"scalars", kept_numbers(pool.scalars)}});
}

std::optional<Pool> read_pool(const fs::path& path) {
    return read_kept(path, [](const KeptJson& kept) {
        return Pool{.statistics = kept.at("statistics"),
                    .faults = kept.at("faults"),
                    .unfit = kept.at("unfit"),
                    .ignores_seed = kept.at("ignores_seed"),
                    .cpu_seconds = kept.at("cpu_seconds"),
                    .scalars = numbers_of(kept.at("scalars"))};
    });
}

}  // namespace grade::calibration
