#include "calibration/replay.h"

#include <cmath>

#include "judging/check_decision.h"
#include "record/record.h"
#include "statistics/distributions.h"
#include "statistics/moments.h"

namespace grade::calibration {

namespace {

struct Replayed {
    Verdict verdict;
    int replicates;
};

Replayed replay_check(const PooledCheck& stored, const Settings& settings, std::mt19937_64& random) {
    const Pool& pool = *stored.pool;
    if (pool.unfit || pool.replicates() == 0) return {Verdict::failed, 2};
    CheckDecision judge(*stored.check, settings);
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

/// A test of fixed size on each statistic of a check.
class FixedTest {
public:
    FixedTest(int replicates, const Settings& settings)
        : replicates_(replicates),
          reject_(student_quantile(replicates - 1, settings.alpha / settings.statistics / 2)),
          accept_(student_quantile(replicates - 1, settings.beta)) {}

    Replayed operator()(const PooledCheck& stored, std::mt19937_64& random) const {
        const Pool& pool = *stored.pool;
        if (pool.unfit || pool.ignores_seed || pool.replicates() == 0) return {Verdict::failed, 2};
        std::uniform_int_distribution<int> any(0, pool.replicates() - 1);
        std::vector<int> rows(std::size_t(replicates_), 0);
        for (int& row : rows) row = any(random);
        Verdict verdict = Verdict::passed;
        for (std::size_t i = 0; i < stored.check->statistics.size(); ++i)
            verdict = worse(verdict, judge(stored.check->statistics[i], pool, i, rows));
        return {verdict, replicates_ + 1};
    }

private:
    Verdict judge(const Statistic& statistic, const Pool& pool, std::size_t i, const std::vector<int>& rows) const {
        Moments moments;
        for (const int row : rows) {
            moments.add(pool.scalar(row, i));
            if (statistic.exact && statistic.truth &&
                judge_exact(pool.scalar(row, i), *statistic.truth, statistic.delta).verdict == Verdict::failed)
                return Verdict::failed;
        }
        if (statistic.exact) return Verdict::passed;
        if (!statistic.truth) return Verdict::inconclusive;
        const double off = std::abs(moments.mean - *statistic.truth), se = moments.standard_error();
        if (!std::isfinite(off) || off - statistic.delta0 > reject_ * se) return Verdict::failed;
        return off + accept_ * se <= statistic.delta ? Verdict::passed : Verdict::inconclusive;
    }

    int replicates_;
    double reject_, accept_;  // Student's quantiles
};

template <class Rule>
Tally replay_by(Rule&& rule, const std::vector<PooledChecks>& seeds, long gradings, std::uint64_t random_seed) {
    std::mt19937_64 random(random_seed);
    Tally tally;
    for (long k = 0; k < gradings; ++k) {
        Verdict all = Verdict::passed;
        for (const PooledCheck& stored : seeds[std::size_t(k) % seeds.size()]) {
            const Replayed outcome = rule(stored, random);
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

}  // namespace

void Tally::add(const Tally& other) {
    gradings += other.gradings, passed += other.passed, failed += other.failed, inconclusive += other.inconclusive;
    replicates += other.replicates, cpu_seconds += other.cpu_seconds;
}

Tally replay(const std::vector<PooledChecks>& seeds, const Settings& settings, long gradings, std::uint64_t random) {
    const auto rule = [&](const PooledCheck& stored, std::mt19937_64& draws) {
        return replay_check(stored, settings, draws);
    };
    return replay_by(rule, seeds, gradings, random);
}

Tally replay_fixed(const std::vector<PooledChecks>& seeds, const Settings& settings, int replicates, long gradings,
                   std::uint64_t random) {
    return replay_by(FixedTest(replicates, settings), seeds, gradings, random);
}

}  // namespace grade::calibration
