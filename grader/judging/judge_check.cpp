#include "judging/judge_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "judging/check_judge.h"
#include "judging/picture_cost.h"
#include "statistics/image_fault.h"

namespace grade {

namespace {

constexpr std::size_t most_pictures = 4;  // replicates whose mean is shown

bool is_render(const Check& check) { return std::holds_alternative<Render>(check.experiment); }

/// What a statistic says about an observation that it fails; empty: nothing.
Shown cause_of(const Statistic& statistic, const Observation& observation) try {
    return statistic.cause ? statistic.cause(observation) : Shown{};
} catch (const std::exception&) {
    return {};
}

/// What an observation shows, in the record. Sure is only what every call shows, which no noise hides.
void tell(const Shown& shown, StatisticRecord& record) {
    record.without_numbers = shown.words;
    record.hint =
        shown.words.empty() || shown.numbers.empty() ? shown.words + shown.numbers : shown.words + ": " + shown.numbers;
    record.worth = !shown.numbers.empty() ? StatisticRecord::Worth::guess
                   : record.exact         ? StatisticRecord::Worth::cause
                                          : StatisticRecord::Worth::fact;
}

/// The record of a statistic; `first` is the first replicate's observation.
StatisticRecord record_of(const Statistic& statistic, const Judgement& judgement, const Observation& first) {
    StatisticRecord record{statistic.id,    statistic.what,       judgement.value,   judgement.truth,
                           judgement.low,   judgement.high,       statistic.delta0,  statistic.delta,
                           statistic.exact, judgement.replicates, judgement.verdict, {}};
    if (judgement.verdict == Verdict::passed) return record;
    if (judgement.verdict == Verdict::failed) tell(cause_of(statistic, first), record);
    if (!record.hint.empty()) return record;
    record.worth = statistic.hint_is_fact ? StatisticRecord::Worth::fact : StatisticRecord::Worth::guess;
    if (judgement.verdict == Verdict::inconclusive) {
        record.hint = fmt::format("neither right nor wrong after {} replicates", judgement.replicates);
    } else if (!std::isfinite(judgement.value) && !statistic.hint_is_fact) {
        record.hint = fmt::format("{}: nothing of it is to be seen", statistic.what);
        record.worth = StatisticRecord::Worth::fact;
    } else if (statistic.hint) {
        record.hint = statistic.hint(judgement.value, judgement.truth);
    }
    if (record.hint.empty()) {
        record.hint = fmt::format("{}: {:.4g}; expected {:.4g}", statistic.what, judgement.value, judgement.truth);
        record.worth = StatisticRecord::Worth::fact;
    }
    record.without_numbers = record.hint;
    return record;
}

/// Throws std::runtime_error where the solution does not run now either: then the machine is at fault.
std::string advice(const Fault& fault, Reference& reference) {
    if (fault.verdict != Verdict::timed_out && fault.verdict != Verdict::crashed) return fault.message;
    const double solution = reference.cpu_seconds();
    if (fault.verdict == Verdict::crashed) return fault.message;
    const std::string needed = solution < 0.01 ? "less than 0.01 s" : fmt::format("{:.2g} s", solution);
    return fmt::format("{}; the solution needs {}{}", fault.message, needed,
                       fault.message.starts_with("ran longer") ? ": look for a loop that does not end" : "");
}

void add_picture(rt::Image& mean, const rt::Image& next, std::size_t count) {
    if (count == 0)
        mean = next;
    else
        for (std::size_t k = 0; k < mean.pixels.size(); ++k)
            mean.pixels[k] += (next.pixels[k] - mean.pixels[k]) / double(count + 1);
}

/// What the page shows of a picture: the solution's, and where both differ.
void add_solution_picture(CheckRecord& record, const std::vector<rt::Image>& shown, Reference& reference) {
    record.solution_picture = reference.picture(int(shown.size()));
    if (record.verdict != Verdict::failed) return;
    std::vector<rt::Image> right;
    for (std::size_t i = 0; i < shown.size(); ++i) right.push_back(reference.image(int(i)));
    record.tiles = compare_tiles(shown, right);
}

}  // namespace

CheckRecord blank_record(const Check& check) {
    CheckRecord record;
    record.name = check.name;
    record.fragment = check.fragment;
    record.share = check.share;
    if (const auto* render = std::get_if<Render>(&check.experiment)) {
        record.scene = render->scene;
        record.samples = render->samples;
        record.sampler = render->sampler;
    }
    return record;
}

std::optional<Fault> unfit(const Check& check, const Observation& first, const Observation& again,
                           Reference& reference) {
    if (!is_same(first, again))
        return Fault{
            Verdict::failed,
            "gives another result when it runs again with the same arguments: a fragment keeps no state, and all its "
            "randomness is in its arguments",
            {},
            Trouble::keeps_state};
    if (is_render(check) && is_quantised(first.image) && !is_quantised(reference.image(0)))
        return Fault{Verdict::failed,
                     "the picture has only the levels of 8 bits: radiance is not to be rounded",
                     {},
                     Trouble::no_radiance};
    return std::nullopt;
}

bool ignores_seed(const Check& check, const Observation& first, const Observation& second, Reference& reference) {
    return is_render(check) && is_same(first, second) && reference.noisy();
}

CheckRecord judge_check(const Check& check, Runner& runner, Reference& reference, const CheckSettings& settings) {
    CheckRecord record = blank_record(check);
    const auto seed = [&](int replicate) {
        return replicate_seed(settings.seed, check, Stream::submission, replicate);
    };
    double fastest = std::numeric_limits<double>::infinity(), counted = 0;
    int answers = 0;
    // Notes what an answer has cost, and what is wrong with that.
    const auto spend = [&]() -> std::optional<Fault> {
        ++answers;
        record.cpu_seconds += runner.seconds();
        fastest = std::min(fastest, runner.seconds());
        const double all = runner.seconds_in_all();
        if (!settings.budget ||
            settings.budget->covers(counted, all, [&] { return answers * reference.cpu_seconds(); }))
            return std::nullopt;
        return Fault{Verdict::timed_out,
                     fmt::format("its answers take too long in all, in this check {:.2g} s for {}; a fragment has {:g} "
                                 "s for all its checks, and "
                                 "{:g} times what the solution needs",
                                 all, answers, Budget::free_seconds, Budget::times),
                     {}};
    };
    const auto give_up = [&](Fault fault) {
        record.verdict = fault.verdict;
        record.message = advice(fault, reference);
        record.trouble = fault.trouble;
        record.excerpt = fault.excerpt;
        return record;
    };

    // the first replicate, twice: the same must come back
    auto outcome = observe(runner, check, seed(0));
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return give_up(*fault);
    const Observation first = std::move(std::get<Observation>(outcome));
    if (const auto fault = spend()) return give_up(*fault);
    std::vector<rt::Image> shown;
    const auto show = [&](const Observation& observation) {
        if (!settings.pictures || !is_render(check) || shown.size() >= most_pictures) return;
        add_picture(record.picture, observation.image, shown.size());
        shown.push_back(observation.image);
    };
    show(first);
    auto repeated = observe(runner, check, seed(0));
    if (const Fault* fault = std::get_if<Fault>(&repeated)) return give_up(*fault);
    if (const auto fault = spend()) return give_up(*fault);
    if (const auto fault = unfit(check, first, std::get<Observation>(repeated), reference)) return give_up(*fault);

    // as many replicates as it takes
    CheckJudge judge(check, settings.statistics);
    const auto scalars_of = [&](const Observation& observation) {
        return [&](std::size_t i) { return measured(check.statistics[i], observation); };
    };
    judge.add(scalars_of(first), [&](std::size_t i) { return reference.exact()[i]; });
    int own = 1, theirs = 0;
    bool seed_ignored = false;
    while (const int wanted = judge.wanted()) {
        const bool needs_reference = judge.needs_reference();
        for (; own < wanted; ++own) {
            auto next = observe(runner, check, seed(own));
            if (const Fault* fault = std::get_if<Fault>(&next)) return give_up(*fault);
            if (const auto fault = spend()) return give_up(*fault);
            const Observation& observation = std::get<Observation>(next);
            if (own == 1) seed_ignored = ignores_seed(check, first, observation, reference);
            show(observation);
            judge.add(scalars_of(observation));
        }
        for (; needs_reference && theirs < wanted; ++theirs) {
            const std::vector<double> values = reference.replicate(theirs);
            judge.add_reference([&](std::size_t i) { return values[i]; });
        }
    }

    record.verdict = judge.verdict();
    for (std::size_t i = 0; i < check.statistics.size(); ++i)
        record.statistics.push_back(record_of(check.statistics[i], *judge.judgements()[i], first));
    // a picture without noise is wrong whatever its mean; what the statistics say about it is closer to the cause
    if (seed_ignored && record.verdict != Verdict::failed) {
        record.verdict = Verdict::failed;
        record.message = "two seeds give one picture: are the random numbers that the fragment is handed used?";
    }
    if (is_render(check)) add_picture_costs(record, first.image, fastest, reference);
    if (settings.pictures && is_render(check)) add_solution_picture(record, shown, reference);
    return record;
}

int noisy_statistics(const std::vector<Check>& checks) {
    int count = 0;
    for (const Check& check : checks)
        count +=
            int(std::ranges::count_if(check.statistics, [](const Statistic& statistic) { return !statistic.exact; }));
    return std::max(count, 1);
}

}  // namespace grade
