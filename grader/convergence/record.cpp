#include "convergence/record.h"

#include <fmt/format.h>

#include <algorithm>

#include "statistics/distributions.h"
#include "statistics/moments.h"

namespace grade::convergence {

namespace {

template <class Member>
Moments moments(const std::vector<Run>& runs, Member member) {
    Moments all;
    for (const Run& run : runs) all.add(run.*member);
    return all;
}

/// The MSE of one independent sample, from all levels of independent samples: N MSE(N) is the same on all of them.
std::optional<double> independent_variance(const SceneRecord& scene) {
    const Curve* curve = scene.find(Who::solution, "random");
    if (!curve) curve = scene.find(Who::submission, "random");
    if (!curve || curve->levels.empty()) return std::nullopt;
    Moments products;
    for (const Level& level : curve->levels) products.add(level.samples * level.mse());
    return products.mean > 0 ? std::optional(products.mean) : std::nullopt;
}

/// Its own, or, for a pattern that gives but one picture, that of another pattern: the fragments have a bias, not the
/// pattern.
std::optional<Estimate> bias_for(const Curve& curve, const SceneRecord& scene) {
    std::optional<Estimate> bias = curve.bias;
    for (const Curve& other : scene.curves)
        if (!curve.bias && other.who == curve.who && other.bias && (!bias || other.bias->se < bias->se))
            bias = other.bias;
    return bias;
}

Comparison comparison(const SceneRecord& scene, const Curve& mine, const Curve& theirs) {
    Comparison result;
    result.sampler = mine.sampler;
    const double time = theirs.levels.back().seconds();
    std::vector<double> mse;
    std::array<std::vector<double>, 2> seconds;
    // replicates that went through all levels
    for (std::size_t replicate = 0; replicate < theirs.levels.front().runs.size(); ++replicate) {
        const auto a = mine.path(replicate), b = theirs.path(replicate);
        if (a.size() < mine.levels.size() || b.size() < theirs.levels.size()) break;
        const auto mine_then = mse_at(a, time), theirs_then = mse_at(b, time);
        if (mine_then && theirs_then) mse.push_back(*mine_then / *theirs_then);
        for (std::size_t k = 0; k < scene.errors.size(); ++k) {
            if (!scene.errors[k]) continue;
            const auto to_mine = seconds_for(a, *scene.errors[k]), to_theirs = seconds_for(b, *scene.errors[k]);
            if (to_mine && to_theirs) seconds[k].push_back(*to_mine / *to_theirs);
        }
    }
    result.mse_at_equal_time = geometric_mean(mse);
    for (std::size_t k = 0; k < seconds.size(); ++k) result.time_at_error[k] = geometric_mean(seconds[k]);
    return result;
}

}  // namespace

const char* name(Who who) { return who == Who::submission ? "submission" : "solution"; }

double Level::mse() const { return moments(runs, &Run::mse).mean; }
double Level::relative() const { return moments(runs, &Run::relative).mean; }
double Level::rays() const { return moments(runs, &Run::rays).mean; }

double Level::seconds() const {
    std::vector<double> all;
    for (const Run& run : runs) all.push_back(run.cpu_seconds);
    if (all.empty()) return 0;
    std::ranges::sort(all);
    return (all[(all.size() - 1) / 2] + all[all.size() / 2]) / 2;
}

std::pair<double, double> Level::mse_interval() const {
    const Moments all = moments(runs, &Run::mse);
    if (all.count < 2) return {0, 0};
    const double reach = student_quantile(all.count - 1, 0.025) * all.standard_error();
    return {std::max(all.mean - reach, 0.0), all.mean + reach};
}

std::vector<LevelErrors> Curve::errors() const {
    std::vector<LevelErrors> all;
    for (const Level& level : levels) {
        all.push_back({double(level.samples), {}});
        for (const Run& run : level.runs) all.back().mse.push_back(run.mse);
    }
    return all;
}

std::vector<Waypoint> Curve::path(std::size_t replicate) const {
    std::vector<Waypoint> places;
    for (const Level& level : levels)
        if (replicate < level.runs.size())
            places.push_back({double(level.samples), level.runs[replicate].cpu_seconds, level.runs[replicate].mse});
    return places;
}

std::optional<Ratio> Curve::seconds_for(double mse) const {
    std::vector<double> all;
    for (std::size_t replicate = 0; !levels.empty() && replicate < levels.back().runs.size(); ++replicate)
        if (const auto seconds = convergence::seconds_for(path(replicate), mse)) all.push_back(*seconds);
    // an error that half of the replicates do not reach is not reached
    if (levels.empty() || 2 * all.size() < levels.back().runs.size()) return std::nullopt;
    return geometric_mean(all);
}

const Curve* SceneRecord::find(Who who, const std::string& sampler) const {
    const auto found =
        std::ranges::find_if(curves, [&](const Curve& c) { return c.who == who && c.sampler == sampler; });
    return found == curves.end() ? nullptr : &*found;
}

const Curve* SceneRecord::biased() const {
    const Curve* worst = nullptr;
    const bool alone = std::ranges::count(curves, Who::submission, &Curve::who) == 0;
    for (const Curve& curve : curves)
        if ((alone || curve.who == Who::submission) && curve.bias && curve.bias->is_positive() &&
            (!worst || curve.bias->value > worst->bias->value))
            worst = &curve;
    return worst;
}

bool ConvergenceRecord::is_biased() const {
    return std::ranges::any_of(scenes, [](const SceneRecord& scene) { return scene.biased() != nullptr; });
}

void analyse(SceneRecord& scene) {
    for (Curve& curve : scene.curves) curve.fit = fit_errors(curve.errors(), bias_for(curve, scene));
    if (const auto v = independent_variance(scene))
        for (std::size_t k = 0; k < scene.errors.size(); ++k) scene.errors[k] = *v / independent_samples[k];
    for (const Curve& curve : scene.curves) {
        const Curve* theirs = scene.find(Who::solution, curve.sampler);
        if (curve.who == Who::submission && theirs && !curve.levels.empty() && !theirs->levels.empty())
            scene.comparisons.push_back(comparison(scene, curve, *theirs));
    }
}

const std::vector<ExpectedOrder>& expected_orders() {
    static const std::vector<ExpectedOrder> all{{"uniform", {}, {}},         {"random", -0.5, -0.5},
                                                {"stratified", -0.75, -1},   {"sobol", -0.75, -1.5},
                                                {"orthogonal", -0.75, -1.5}, {"blue_noise", -0.75, -1.5}};
    return all;
}

std::string expected_order(const std::string& sampler) {
    for (const ExpectedOrder& order : expected_orders()) {
        if (order.sampler != sampler || !order.edge) continue;
        if (*order.edge == *order.smooth) return fmt::format("{:.2f}", *order.edge);
        return fmt::format("{:.2f} to {:.2f}", *order.edge, *order.smooth);
    }
    return "any";
}

}  // namespace grade::convergence
