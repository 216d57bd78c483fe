#include "calibration/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "calibration/results.h"
#include "files/files.h"
#include "judging/grading.h"
#include "judging/run_check.h"
#include "programs/parallel.h"
#include "statistics/distributions.h"

namespace grade::calibration {

namespace {

constexpr int nominal_draws = 200'000;

/// The stores of one program: all of its grading seeds that are complete.
struct Stores {
    std::vector<std::unique_ptr<Pool>> pools;  // what `seeds` points to
    std::vector<PooledChecks> seeds;
    int least = 0;
};

/// enough  replicates that each must hold
Stores stores_of(const Workshop& workshop, const std::string& name, const std::set<std::string>& fragments,
                 int enough = 0) {
    Stores stores;
    for (int part = 0; part < workshop.amount().seeds; ++part) {
        PooledChecks checks;
        std::size_t wanted = 0;
        int least = std::numeric_limits<int>::max();
        for (const Check& check : workshop.checks(pool_seed(part))) {
            if (!fragments.contains(check.fragment)) continue;
            ++wanted;
            auto pool = read_pool(pool_file(workshop, name, check, pool_seed(part)));
            if (!pool) continue;
            if (pool->faults == 0) least = std::min(least, pool->replicates());
            stores.pools.push_back(std::make_unique<Pool>(std::move(*pool)));
            checks.push_back({&check, stores.pools.back().get()});
        }
        if (checks.size() != wanted || least < enough) continue;
        stores.seeds.push_back(std::move(checks));
        if (least < std::numeric_limits<int>::max()) stores.least += least;
    }
    return stores;
}

/// How many replicates a test of fixed size needs to tell right from a deviation of delta, with the same alpha and
/// beta.
int fixed_replicates(const PooledCheck& stored, const Settings& settings) {
    double most = 16;
    for (std::size_t i = 0; i < stored.check->statistics.size(); ++i) {
        const Statistic& statistic = stored.check->statistics[i];
        if (statistic.exact) continue;
        std::vector<double> all;
        for (int k = 0; k < stored.pool->replicates(); ++k) all.push_back(stored.pool->scalar(k, i));
        const double deviation = moments_of(all).deviation();
        // the quantiles depend on the number that they decide: a few rounds settle it
        double n = 16;
        for (int round = 0; round < 20; ++round) {
            const double reach = student_quantile(std::round(n) - 1, settings.alpha / settings.statistics / 2) +
                                 student_quantile(std::round(n) - 1, settings.beta);
            n = std::clamp(std::pow(reach * deviation / (statistic.delta - statistic.delta0), 2), 16.0, 1e5);
        }
        most = std::max(most, n);
    }
    return int(std::ceil(most));
}

Settings settings_of(const Workshop& workshop, int cap) {
    Settings settings;
    settings.statistics = noisy_statistics(workshop.checks(pool_seed(0)));
    settings.cap = cap;
    return settings;
}

/// What a budget makes of one more wrong variant.
void add_wrong(Budget& budget, const std::string& variant, std::mutex& lock, const Tally& tally) {
    const std::scoped_lock guard(lock);
    budget.wrong.add(tally);
    const double missed = 1 - double(tally.failed) / double(tally.gradings);
    if (missed > budget.worst_wrong) budget.worst_wrong = missed, budget.worst = variant;
}

/// A result; null: it is not there yet.
nlohmann::json result(const fs::path& file) {
    const auto text = read_text(file);
    return text ? nlohmann::json::parse(*text) : nullptr;
}

void read_peers(const Workshop& workshop, VariantSummary& row) {
    const auto json = result(peer_file(workshop, *row.variant));
    if (json.is_null()) return;
    row.pictures = json.at("pictures");
    row.peers = {json.at("z_test"), json.at("mean_difference"), json.at("global_mean")};
}

/// Real gradings: what became of each variant, and of what stands beside it.
void read_real(const Workshop& workshop, const std::vector<Bundle>& bundles, const std::vector<std::uint64_t>& seeds,
               bool wrong, std::vector<VariantSummary>& rows, Summary& summary) {
    std::map<const Variant*, VariantSummary*> row_of;
    for (VariantSummary& row : rows) row_of[row.variant] = &row;
    double seconds = 0;
    for (const Bundle& bundle : bundles)
        for (const std::uint64_t seed : seeds) {
            const auto grading = read_grading(real_file(workshop, bundle, seed));
            if (!grading) continue;
            bool failed = false, open = false;
            for (const RealVerdict& verdict : grading->fragments) {
                seconds += wrong ? 0 : verdict.cpu_seconds;
                const auto changed = std::ranges::find(bundle.variants, verdict.fragment, &Variant::fragment);
                const bool found = is_found(verdict.verdict), passed = verdict.verdict == Verdict::passed;
                if (changed == bundle.variants.end()) {
                    ++summary.neighbours;
                    summary.spoiled += !passed;
                } else {
                    VariantSummary& row = *row_of.at(*changed);
                    ++row.gradings;
                    row.found += found;
                    row.open += !found && !passed;
                    row.named += found && says_one_of(verdict.message, row.variant->says);
                    if (found) row.hints.push_back(verdict);
                }
                failed = failed || found;
                open = open || (!found && !passed);
                if (!passed && (!wrong || changed == bundle.variants.end()))
                    summary.false_failures.push_back(fmt::format("{}, seed {}, {}: {}: {}", bundle.name, seed,
                                                                 verdict.fragment, name(verdict.verdict),
                                                                 verdict.message));
            }
            if (!wrong)
                ++summary.right_gradings, summary.right_failures += failed, summary.right_open += open && !failed;
        }
    if (!wrong && summary.right_gradings > 0) summary.whole_seconds = seconds / summary.right_gradings;
}

/// How many of the verdicts say that a fragment is wrong.
int count_found(const nlohmann::json& verdicts) {
    return int(std::ranges::count_if(verdicts, [](const std::string& text) {
        const Verdict verdict = verdict_named(text);
        return verdict != Verdict::passed && verdict != Verdict::inconclusive;
    }));
}

void read_doses(const Workshop& workshop, Summary& summary) {
    for (const Variant* variant : workshop.variants(Variant::Kind::dose)) {
        const auto json = result(result_file(workshop, *variant));
        if (json.is_null()) continue;
        Dose dose{variant, {}};
        for (const std::string& size : variant->doses) {
            const auto& verdicts = json.at(size);
            dose.found.emplace_back(size, double(count_found(verdicts)) / double(verdicts.size()));
        }
        summary.doses.push_back(std::move(dose));
    }
    for (const Variant* variant : workshop.variants(Variant::Kind::confined)) {
        const auto json = result(result_file(workshop, *variant));
        if (json.is_null()) continue;
        const auto& verdicts = json.at("verdicts");
        summary.confined.push_back(
            {variant, json.at("changed"), json.at("pixels"), int(verdicts.size()), count_found(verdicts)});
    }
}

}  // namespace

std::pair<double, double> rate_bounds(long hits, long all) {
    using Beta = boost::math::beta_distribution<double>;
    if (all == 0) return {0, 1};
    const double low = hits == 0 ? 0 : boost::math::quantile(Beta(double(hits), double(all - hits + 1)), 0.025);
    const double high =
        hits == all ? 1 : boost::math::quantile(Beta(double(hits + 1), double(all - hits)), hits == 0 ? 0.95 : 0.975);
    return {low, high};
}

namespace {

/// Replays: many short jobs, in any order, which fill in a summary.
class Replays {
public:
    Replays(const Workshop& workshop, Summary& summary)
        : workshop_(workshop),
          summary_(summary),
          settings_(settings_of(workshop, GradingSettings{}.replicates)),
          draws_(workshop.amount().draws),
          enough_(std::min(4 * settings_.cap, workshop.amount().replicates / workshop.amount().seeds)),
          solution_(stores_of(workshop, "solution", workshop.fragments(), enough_)) {
        summary.noisy = settings_.statistics;
        summary.least_replicates = solution_.least;
        if (!solution_.seeds.empty())
            for (const PooledCheck& stored : solution_.seeds.front())
                fixed_[key_of(*stored.check)] = fixed_replicates(stored, settings_);
    }

    void run(int jobs, const Progress::Listener& listener) {
        if (!solution_.seeds.empty()) add_solution();
        for (auto* rows : {&summary_.right, &summary_.wrong})
            for (VariantSummary& row : *rows) add(row.variant->name, [&] { replay_variant(row); });
        Progress progress(listener);
        progress.expect(Work::check, int(work_.size()));
        in_parallel(int(work_.size()), jobs, [&](int i) {
            const auto& [name, job] = work_[std::size_t(i)];
            progress.tell("replays: " + name);
            job();
            progress.done(Work::check);
        });
    }

private:
    void add(const std::string& name, std::function<void()> job) { work_.emplace_back(name, std::move(job)); }

    void add_solution() {
        constexpr int pieces = 50;
        for (int piece = 0; piece < pieces; ++piece)
            add("the solution", [this, piece] {
                const Tally tally = replay(solution_.seeds, settings_, draws_ / pieces, 1 + std::uint64_t(piece));
                const std::scoped_lock guard(lock_);
                summary_.solution.add(tally);
            });
        for (Budget& budget : summary_.budgets)
            add("budgets", [&] { budget.right = replay_within(budget, solution_, draws_ / 50, 99); });
        for (Budget& budget : summary_.fixed_budgets)
            add("fixed budgets", [&] { budget.right = replay_exactly(budget, solution_, draws_ / 50, 99); });
        add("rates of each statistic",
            [this] { summary_.nominal = nominal_rates(solution_.seeds.front(), nominal_draws, 7); });
    }

    void replay_variant(VariantSummary& row) {
        read_peers(workshop_, row);
        const Variant& variant = *row.variant;
        // Few replicates have a mean of their own, off the truth: many draws from them would be of another, wrong
        // program.
        const Stores stores =
            stores_of(workshop_, variant.name, {variant.fragment}, variant.kind == Variant::Kind::right ? enough_ : 0);
        if (stores.seeds.empty()) return;
        row.replayed = replay(stores.seeds, settings_, draws_ / 10, 3);
        for (const PooledCheck& stored : stores.seeds.front())
            row.fixed_seconds += fixed_[key_of(*stored.check)] * stored.pool->seconds_per_replicate();
        if (variant.kind == Variant::Kind::wrong) {
            for (Budget& budget : summary_.budgets)
                add_wrong(budget, variant.name, lock_, replay_within(budget, stores, draws_ / 500, 5));
            for (Budget& budget : summary_.fixed_budgets)
                add_wrong(budget, variant.name, lock_, replay_exactly(budget, stores, draws_ / 500, 5));
        }
        const std::scoped_lock guard(lock_);
        if (stores.least > 0) summary_.least_replicates = std::min(summary_.least_replicates, stores.least);
    }

    Tally replay_within(const Budget& budget, const Stores& stores, long draws, std::uint64_t random) const {
        return replay(stores.seeds, settings_of(workshop_, budget.replicates), draws, random);
    }
    Tally replay_exactly(const Budget& budget, const Stores& stores, long draws, std::uint64_t random) const {
        return replay_fixed(stores.seeds, settings_, budget.replicates, draws, random);
    }

    const Workshop& workshop_;
    Summary& summary_;
    Settings settings_;
    long draws_;
    int enough_;  // replicates that the stores of what is right must hold
    Stores solution_;
    std::map<std::string, int> fixed_;  // replicates of a test of fixed size, by check
    std::mutex lock_;
    std::vector<std::pair<std::string, std::function<void()>>> work_;
};

}  // namespace

Summary summarize(const Workshop& workshop, int jobs, const Progress::Listener& listener) {
    Summary summary;
    Progress(listener).tell("reading what was measured");
    for (const Step& step : steps_of(workshop)) ++summary.steps, summary.steps_done += step.is_done();
    for (const Variant* variant : workshop.variants(Variant::Kind::right)) summary.right.push_back({variant});
    for (const Variant* variant : workshop.variants(Variant::Kind::wrong)) summary.wrong.push_back({variant});
    read_real(workshop, right_bundles(workshop), right_seeds(workshop), false, summary.right, summary);
    read_real(workshop, wrong_bundles(workshop), wrong_seeds(workshop), true, summary.wrong, summary);
    read_doses(workshop, summary);
    for (const Bundle& bundle : bundles_under_load(workshop))
        if (const auto json = result(load_file(workshop, bundle)); !json.is_null())
            ++summary.under_load, summary.same_under_load += json.at("same").get<bool>();
    for (const int n : {8, 16, 32, 64, 128, 256, 512}) summary.budgets.push_back({.replicates = n});
    for (const int n : {2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256})
        summary.fixed_budgets.push_back({.replicates = n});
    Replays(workshop, summary).run(jobs, listener);
    return summary;
}

}  // namespace grade::calibration
