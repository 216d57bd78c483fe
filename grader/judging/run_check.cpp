#include "judging/run_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

#include "diagnosis/divergence.h"
#include "judging/blank_record.h"
#include "judging/check_decision.h"
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
    record.chi_squared = statistic.chi_squared;
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
        record.hint = in_numbers(record);
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
                       fault.trouble == Trouble::endless ? ": look for a loop that does not end" : "");
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

std::optional<Fault> unfit(const Check& check, const Observation& first, const Observation& again,
                           Reference& reference) {
    if (!is_same(first, again))
        return Fault{Verdict::failed,
                     "gives another result when it runs again with the same arguments: a fragment keeps no state, and "
                     "all its randomness is in its arguments",
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

namespace {

/// One check of one submission, from its first answer to its record.
class Trial {
public:
    Trial(const Check& check, Runner& runner, Reference& reference, const CheckSettings& settings)
        : check_(check),
          runner_(runner),
          reference_(reference),
          settings_(settings),
          judge_(check, settings.statistics),
          record_(blank_record(check)) {
        runner.begin_count();
    }

    CheckRecord run() {
        if (const auto fault = begin()) return broken(*fault);
        if (const auto fault = repeat()) return broken(*fault);
        conclude();
        return std::move(record_);
    }

private:
    /// A fault where the answers so far have cost more than the fragment's budget.
    std::optional<Fault> overspent() {
        const double all = runner_.seconds_in_all();
        if (!settings_.budget ||
            settings_.budget->covers(counted_, all, [&] { return answers_ * reference_.cpu_seconds(); }))
            return std::nullopt;
        return Fault{Verdict::timed_out,
                     fmt::format("its answers take too long in all, in this check {:.2g} s for {}; a fragment has {:g} "
                                 "s for all its checks, and {:g} times what the solution needs",
                                 all, answers_, Budget::free_seconds, Budget::times),
                     {}};
    }

    Outcome<Observation> ask(int replicate) {
        const std::uint64_t seed = replicate_seed(settings_.grading.seed, check_, Stream::submission, replicate);
        Outcome<Observation> answer = observe(runner_, check_, seed);
        ++answers_;
        const Fault* broken = std::get_if<Fault>(&answer);
        if (broken && broken->verdict == Verdict::timed_out) return answer;
        if (auto fault = overspent()) return *fault;  // a crash costs time like an answer
        if (broken) return answer;
        record_.cpu_seconds += runner_.seconds();
        fastest_ = std::min(fastest_, runner_.seconds());
        return answer;
    }

    /// How the paths part in the pixel of the clearest tile that is off most in the first picture.
    void trace() {
        const rt::Image& mine = first_.image;
        const rt::Image& right = reference_.image(0);
        const auto off = [&](rt::ivec2 p) { return glm::length(mine.at(p.x, p.y) - right.at(p.x, p.y)); };
        const int tile = int(record_.tiles.clearest()), side = Tiles::side;
        const rt::ivec2 corner(tile % record_.tiles.columns * side, tile / record_.tiles.columns * side);
        rt::ivec2 pixel = corner;
        for (int y = corner.y; y < std::min(corner.y + side, mine.height); ++y)
            for (int x = corner.x; x < std::min(corner.x + side, mine.width); ++x)
                if (off({x, y}) > off(pixel)) pixel = {x, y};
        const auto told =
            settings_.another()->trace(std::get<Render>(check_.experiment),
                                       replicate_seed(settings_.grading.seed, check_, Stream::submission, 0), pixel);
        if (const auto* text = std::get_if<std::string>(&told))
            record_.parting = first_divergence(*text, reference_.trace(pixel));
        if (!record_.parting.empty())
            record_.parting = fmt::format("pixel {},{}\n{}", pixel.x, pixel.y, record_.parting);
    }

    void take(const Observation& observation) {
        judge_.add([&](std::size_t i) { return measured(check_.statistics[i], observation); });
    }

    void show(const Observation& observation) {
        if (!settings_.grading.pictures || !is_render(check_) || shown_.size() >= most_pictures) return;
        add_picture(record_.picture, observation.image, shown_.size());
        shown_.push_back(observation.image);
    }

    /// The first replicate, twice: the same must come back.
    std::optional<Fault> begin() {
        Outcome<Observation> answer = ask(0);
        if (const Fault* fault = std::get_if<Fault>(&answer)) return *fault;
        first_ = std::move(std::get<Observation>(answer));
        show(first_);
        const Outcome<Observation> again = ask(0);
        if (const Fault* fault = std::get_if<Fault>(&again)) return *fault;
        return unfit(check_, first_, std::get<Observation>(again), reference_);
    }

    /// As many replicates as it takes.
    std::optional<Fault> repeat() {
        judge_.add([&](std::size_t i) { return measured(check_.statistics[i], first_); },
                   [&](std::size_t i) { return reference_.exact()[i]; });
        int own = 1, theirs = 0;
        while (const int wanted = judge_.wanted()) {
            const bool needs_reference = judge_.needs_reference();
            for (; own < wanted; ++own) {
                const Outcome<Observation> answer = ask(own);
                if (const Fault* fault = std::get_if<Fault>(&answer)) return *fault;
                const Observation& observation = std::get<Observation>(answer);
                if (own == 1) seed_ignored_ = ignores_seed(check_, first_, observation, reference_);
                show(observation);
                take(observation);
            }
            for (; needs_reference && theirs < wanted; ++theirs) {
                const std::vector<double> values = reference_.replicate(theirs);
                judge_.add_reference([&](std::size_t i) { return values[i]; });
            }
        }
        return std::nullopt;
    }

    void conclude() {
        record_.verdict = judge_.verdict();
        for (std::size_t i = 0; i < check_.statistics.size(); ++i)
            record_.statistics.push_back(record_of(check_.statistics[i], *judge_.judgements()[i], first_));
        // a picture without noise is wrong whatever its mean; what the statistics say about it is closer to the cause
        if (seed_ignored_ && record_.verdict != Verdict::failed) {
            record_.verdict = Verdict::failed;
            record_.message = "two seeds give one picture: are the random numbers that the fragment is handed used?";
        }
        if (is_render(check_)) add_picture_costs(record_, first_.image, fastest_, reference_);
        if (!settings_.grading.pictures || !is_render(check_)) return;
        add_solution_picture(record_, shown_, reference_);
        if (!record_.tiles.empty() && settings_.another) trace();
    }

    CheckRecord broken(const Fault& fault) {
        record_.verdict = fault.verdict;
        record_.message = advice(fault, reference_);
        record_.trouble = fault.trouble;
        record_.excerpt = fault.excerpt;
        return std::move(record_);
    }

    const Check& check_;
    Runner& runner_;
    Reference& reference_;
    const CheckSettings& settings_;
    CheckDecision judge_;
    CheckRecord record_;
    Observation first_;
    std::vector<rt::Image> shown_;  // the first replicates' pictures
    double fastest_ = std::numeric_limits<double>::infinity(), counted_ = 0;
    int answers_ = 0;
    bool seed_ignored_ = false;
};

}  // namespace

CheckRecord run_check(const Check& check, Runner& runner, Reference& reference, const CheckSettings& settings) {
    return Trial(check, runner, reference, settings).run();
}

int noisy_statistics(const std::vector<Check>& checks) {
    int count = 0;
    for (const Check& check : checks)
        count +=
            int(std::ranges::count_if(check.statistics, [](const Statistic& statistic) { return !statistic.exact; }));
    return std::max(count, 1);
}

}  // namespace grade
