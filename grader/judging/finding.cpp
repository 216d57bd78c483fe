#include "judging/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <memory>

#include "diagnosis/explain.h"
#include "files/files.h"
#include "judging/experiment.h"
#include "textbook/in_double.h"
#include "textbook/source.h"

namespace grade {

namespace {

constexpr std::size_t most_calls = 256, more_times = 8;
constexpr std::size_t most_of_all = 40'000;
constexpr std::uint64_t seeds = 4;  // whose parameters differ
constexpr double patience = 5;      // CPU seconds for one answer; on a busy machine it waits longer

double thread_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
}

using Answers = std::function<Outcome<Rows>(Runner& runner, const Rows& rows)>;

/// The program answers until it breaks down; then another one, a few times, and no longer than it is given.
///
/// hangs  where given: there is no other one after an answer that takes all of its time
Ask asking(const fs::path& program, const Sandbox& sandbox, const fs::path& meshes, double& seconds, Answers answers,
           bool* hangs = nullptr) {
    struct State {
        std::unique_ptr<Runner> runner;
        int starts = 0;
        double cpu = 0, clock = 0;  // seconds; by the clock, without what it waited for a processor
    };
    return [=, &sandbox, &seconds, state = std::make_shared<State>()](const Rows& rows) -> Rows {
        constexpr int most_starts = 4;
        // in all: on a busy machine the clock runs on while the grader itself waits, and no hint may depend on that
        constexpr double most_cpu = 15, most_by_clock = 45;
        if (state->cpu > most_cpu || state->clock > most_by_clock) return {};
        if (!state->runner) {
            if (++state->starts > most_starts) return {};
            state->runner = std::make_unique<Runner>(program, sandbox, meshes, patience);
        }
        const auto start = std::chrono::steady_clock::now();
        state->runner->begin_count();
        auto outcome = answers(*state->runner, rows);
        const double cpu = state->runner->seconds();
        seconds += cpu, state->cpu += cpu, state->clock += state->runner->seconds_in_all();
        if (Rows* all = std::get_if<Rows>(&outcome)) return std::move(*all);
        state->clock += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        state->runner.reset();
        if (hangs && std::get<Fault>(outcome).trouble == Trouble::endless) *hangs = true, state->starts = most_starts;
        return {};
    };
}

/// The answers of a program with the fragment.
///
/// width  numbers of an answer: the solution's say it, and shorter ones are none, for whoever writes into the grader's
///        channel may answer with rows of any length
Answers answers_to(const std::string& fragment, std::shared_ptr<std::size_t> width, bool is_solution) {
    return [=](Runner& runner, const Rows& rows) {
        auto outcome = runner.probe(fragment, rows);
        const Rows* answers = std::get_if<Rows>(&outcome);
        if (!answers) return outcome;
        if (is_solution && !answers->empty()) *width = answers->front().size();
        if (std::ranges::any_of(*answers, [&](const Row& row) { return row.size() < *width; }))
            return Outcome<Rows>(Fault{Verdict::crashed, "an answer is too short", {}});
        return outcome;
    };
}

/// Calls that the fragment's checks make, as many of each, with the parameters of several seeds: from all of its rows,
/// which may be of several kinds.
Rows calls_of(const std::string& fragment, const std::vector<Check>& checks, std::uint64_t seed,
              std::size_t most_calls) {
    std::vector<Check> own;
    for (const Check& check : checks)
        if (check.fragment == fragment) own.push_back(check);
    for (std::uint64_t more = 1; more < seeds; ++more)
        for (Check& check : checks_of(fragment, seed + more)) own.push_back(std::move(check));
    std::erase_if(own, [](const Check& check) { return !std::holds_alternative<Probe>(check.experiment); });
    Rows all;
    for (std::size_t i = 0; i < own.size(); ++i) {
        Generator generator(replicate_seed(seed + i, own[i], Stream::submission, 0));
        const Rows rows = std::get<Probe>(own[i].experiment).inputs(generator);
        const std::size_t count = std::min(rows.size(), most_calls / own.size() + 1);
        // one of each so many, not the first: rows of several kinds may take turns
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t first = k * rows.size() / count, next = (k + 1) * rows.size() / count;
            all.push_back(rows[first + (7 * k + 3) % (next - first)]);
        }
    }
    return all;
}

/// Whether the answers to calls are wrong; none where there are not as many.
std::vector<bool> are_wrong(const Signature& signature, const Rows& calls, const Ask& mine, const Ask& right) {
    const Rows own = mine(calls), due = right(calls);
    std::vector<bool> wrong;
    if (own.size() != calls.size() || due.size() != calls.size()) return wrong;
    for (std::size_t k = 0; k < calls.size(); ++k)
        wrong.push_back(own[k].size() != due[k].size() || !is_equal(signature.of_result(due[k]), own[k], due[k]));
    return wrong;
}

/// Calls; where few of them are wrong, those of more that are, too: a rule needs some.
Rows telling_calls(const std::string& fragment, const std::vector<Check>& checks, std::uint64_t seed,
                   const Signature& signature, const Ask& mine, const Ask& right) {
    constexpr std::ptrdiff_t few = 12, enough = 32;
    Rows calls = calls_of(fragment, checks, seed, most_calls);
    std::ptrdiff_t count = std::ranges::count(are_wrong(signature, calls, mine, right), true);
    if (count >= few) return calls;
    Rows more = calls_of(fragment, checks, seed + seeds, more_times * most_calls);
    const std::vector<bool> wrong = are_wrong(signature, more, mine, right);
    for (std::size_t k = 0; k < wrong.size() && count < enough; ++k)
        if (wrong[k]) calls.push_back(std::move(more[k])), ++count;
    return calls;
}

/// Some of all calls whose answers are no numbers: there may be none among those that are looked at.
void add_not_finite(Rows& calls, const Rows& all, const Ask& mine, const Ask& right) {
    constexpr std::size_t enough = 16;
    const Rows own = mine(all), due = right(all);
    if (own.size() != all.size() || due.size() != all.size()) return;
    std::size_t count = 0;
    for (std::size_t k = 0; k < all.size() && count < enough; ++k)
        if (is_nan(own[k], due[k])) calls.push_back(all[k]), ++count;
}

/// Whether the same calls in the other order, of a program that has just begun, have other answers.
bool keeps_something(const Rows& calls, const Ask& mine, const Ask& again) {
    Observation first, second;
    first.outputs = mine(calls), second.outputs = again(Rows(calls.rbegin(), calls.rend()));
    std::ranges::reverse(second.outputs);
    return first.outputs.size() == second.outputs.size() && differs(first, second);
}

/// The fragment with expressions that can be changed; none: its source cannot be read, or not compiled so.
std::optional<Editable> editable_of(Programs& programs, const std::string& fragment, const fs::path& meshes,
                                    double& seconds) try {
    const std::string& text = programs.text(fragment);
    const auto read = textbook::needs_preprocessor(text) ? programs.preprocessed(fragment) : std::optional(text);
    if (!read) return std::nullopt;
    textbook::EditableSource source = textbook::editable(*read);
    const auto program = programs.with_text(fragment, source.text, "editable");
    if (!program) return std::nullopt;
    const std::size_t most = std::max<std::size_t>(16, source.nodes.size());
    const auto edited = [fragment, most](Runner& runner, const Rows& calls) {
        return runner.edited(fragment, calls, most);
    };
    return Editable{std::move(source.nodes), std::move(source.varying),
                    asking(*program, programs.sandbox(), meshes, seconds, edited)};
} catch (const std::exception&) {
    return std::nullopt;
}

/// The fragment with doubles in place of floats; none: it has none, or cannot be compiled so.
std::optional<InDouble> in_double_of(Programs& programs, const std::string& fragment, const fs::path& meshes,
                                     double& seconds, const std::shared_ptr<std::size_t>& width) {
    const auto widened = textbook::in_double(programs.text(fragment));
    const auto program = widened ? programs.with_text(fragment, widened->text, "in_double") : std::nullopt;
    if (!program) return std::nullopt;
    return InDouble{asking(*program, programs.sandbox(), meshes, seconds, answers_to(fragment, width, false)),
                    widened->line, "`double` in place of `float`",
                    "single precision has 7 digits, and fewer are left where numbers cancel"};
}

/// The fragment with a real number in place of a whole one.
std::vector<MadeInDouble> with_reals_of(Programs& programs, const std::string& fragment, const fs::path& meshes,
                                        double& seconds, const std::shared_ptr<std::size_t>& width) {
    std::vector<MadeInDouble> all;
    for (textbook::Widened& widened : textbook::with_reals(programs.text(fragment)))
        all.emplace_back([&, fragment, meshes, width, number = all.size(),
                          widened = std::move(widened)]() -> std::optional<InDouble> {
            const auto program = programs.with_text(fragment, widened.text, fmt::format("with_real_{}", number));
            if (!program) return std::nullopt;
            return InDouble{asking(*program, programs.sandbox(), meshes, seconds, answers_to(fragment, width, false)),
                            widened.line,
                            widened.is_quotient ? "`* 1.0 /` in place of `/`" : "`double` in place of `int`",
                            widened.is_quotient ? "a quotient of whole numbers loses what is behind the point"
                                                : "a whole number loses what is behind the point"};
        });
    return all;
}

}  // namespace

Finding find_cause(Programs& programs, const Toolchain& chain, const std::string& fragment,
                   const std::vector<Check>& checks, std::uint64_t seed, bool not_finite) try {
    const auto header = read_text(chain.includes.front() / "rt/fragments.h");
    const auto signature = signature_of(fragment, header.value_or(""));
    if (!signature) return {};
    const fs::path meshes = chain.source / "scenes";
    const fs::path own = programs.copy_for(fragment + ".calls", programs.with({fragment}).program);
    double seconds = 0;
    const double before = thread_seconds();
    const auto width = std::make_shared<std::size_t>(0);
    const Sandbox& sandbox = programs.sandbox();
    bool hangs = false;
    const Ask mine = asking(own, sandbox, meshes, seconds, answers_to(fragment, width, false), &hangs),
              right = asking(programs.with({}).program, sandbox, meshes, seconds, answers_to(fragment, width, true));
    Rows calls = telling_calls(fragment, checks, seed, *signature, mine, right);
    if (hangs) return {};
    if (not_finite) add_not_finite(calls, calls_of(fragment, checks, seed, most_of_all), mine, right);
    const Recompiled source{[&] { return editable_of(programs, fragment, meshes, seconds); },
                            [&] { return in_double_of(programs, fragment, meshes, seconds, width); },
                            with_reals_of(programs, fragment, meshes, seconds, width),
                            [&] { return calls_of(fragment, checks, seed + 2 * seeds, more_times * most_calls); }};
    const Ask again = asking(own, sandbox, meshes, seconds, answers_to(fragment, width, false));
    Finding finding;
    if (!calls.empty() && keeps_something(calls, mine, again))
        finding.how =
            "the answer to a call hangs on the calls before it: something is kept in between, as in a variable "
            "that is `static` or global, or read before it is set; a fragment answers by its arguments alone";
    else if (!calls.empty())
        finding = explain(*signature, calls, mine, right, source);
    finding.cpu_seconds = seconds + thread_seconds() - before;
    return finding;
} catch (const std::bad_alloc&) {
    return {};  // the verdict stands, without a hint of calls
}

}  // namespace grade
