#include "calibration/replay.h"

#include "judging/check_judge.h"
#include "report/record.h"

namespace grade {

namespace {

struct Replayed {
    Verdict verdict;
    int replicates;
};

Replayed replay_check(const PooledCheck& stored, const Settings& settings, std::mt19937_64& random) {
    const Pool& pool = *stored.pool;
    if (pool.unfit || pool.replicates() == 0) return {Verdict::failed, 2};
    CheckJudge judge(*stored.check, settings);
    std::uniform_int_distribution<int> any(0, pool.replicates() - 1);
    int count = 0;
    while (count == 0 || count < judge.wanted()) {
        const int row = any(random);
        judge.add([&](std::size_t i) { return pool.scalar(row, i); });
        ++count;
    }
    const Verdict verdict = judge.verdict();
    const bool ignored = pool.ignores_seed && count > 1;
    return {ignored ? Verdict::failed : verdict, count + 1};  // the first replicate runs twice
}

}  // namespace

void Tally::add(const Tally& other) {
    gradings += other.gradings, passed += other.passed, failed += other.failed, inconclusive += other.inconclusive;
    replicates += other.replicates, cpu_seconds += other.cpu_seconds;
}

Tally replay(const std::vector<PooledChecks>& seeds, const Settings& settings, long gradings,
             std::uint64_t random_seed) {
    std::mt19937_64 random(random_seed);
    Tally tally;
    for (long k = 0; k < gradings; ++k) {
        Verdict all = Verdict::passed;
        for (const PooledCheck& stored : seeds[std::size_t(k) % seeds.size()]) {
            const Replayed outcome = replay_check(stored, settings, random);
            all = worse(all, outcome.verdict);
            tally.replicates += outcome.replicates;
            tally.cpu_seconds += outcome.replicates * stored.pool->seconds_per_replicate();
        }
        ++tally.gradings;
        tally.passed += all == Verdict::passed;
        tally.failed += all == Verdict::failed;
        tally.inconclusive += all == Verdict::inconclusive;
    }
    return tally;
}

}  // namespace grade
