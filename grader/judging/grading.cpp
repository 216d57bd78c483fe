#include "judging/grading.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>

#include "files/files.h"
#include "judging/blank_record.h"
#include "judging/breakdown.h"
#include "judging/fault.h"
#include "judging/finding.h"
#include "judging/lanes.h"
#include "judging/provenance.h"
#include "judging/run_check.h"
#include "judging/time_outs.h"
#include "programs/parallel.h"

namespace grade {

namespace {

/// Everything that one grading shares. The steps are below, in their order.
class Grading {
public:
    Grading(Programs& programs, const Assignment& assignment, const Toolchain& chain, const FutureChecks& checks,
            const GradingSettings& settings, Progress& progress)
        : programs_(programs),
          chain_(chain),
          checks_(checks),
          settings_(settings),
          progress_(progress),
          record_(blank_record(programs, assignment, settings)),
          check_settings_{settings} {}

    Record run();

private:
    void compile();
    void add_checks();
    std::vector<Task> recall();
    void link(std::vector<Task>& open);
    void judge_all(const std::vector<Task>& open);
    void judge_next(const Task& task, Lane& lane, SolutionRunners& solutions);
    CheckRecord judge(const Task& task, Lane& lane, SolutionRunners& solutions);
    Finding explain(const FragmentRecord& fragment);
    std::string made_from(const std::string& fragment) const;
    void finish(FragmentRecord& fragment);

    Programs& programs_;
    const Toolchain& chain_;
    const FutureChecks checks_;
    const GradingSettings& settings_;
    Progress& progress_;
    Record record_;
    std::vector<Task> tasks_;
    CheckSettings check_settings_;
    int links_expected_ = 0, checks_expected_ = 0;
    std::map<std::string, Budget> budgets_;  // by fragment
    std::map<std::string, int> left_;        // checks
    std::mutex lock_;
};

bool is_measured(const CheckRecord& record) {
    return record.verdict == Verdict::passed || record.verdict == Verdict::failed ||
           record.verdict == Verdict::inconclusive;
}

void Grading::add_checks() {
    const std::vector<Check>& checks = checks_.get();
    check_settings_.statistics.statistics = settings_.statistics > 0 ? settings_.statistics : noisy_statistics(checks);
    check_settings_.statistics.cap = settings_.replicates;
    record_.limits.replicates = settings_.replicates;
    record_.limits.statistics = check_settings_.statistics.statistics;
    record_.provenance.checks = hash_of(checks);
    for (FragmentRecord& fragment : record_.fragments) {
        std::vector<const Check*> own;
        for (const Check& check : checks)
            if (check.fragment == fragment.name) own.push_back(&check), fragment.checks.push_back(blank_record(check));
        if (own.empty())
            throw std::runtime_error(fmt::format(
                "assignment.toml lists {0}, and this grader has no check of it. That is no verdict on the submission: "
                "expected a build with what grader/checks/{0}.cpp returns, or no {0} in assignment.toml",
                fragment.name));
        for (std::size_t i = 0; i < own.size(); ++i) tasks_.push_back({own[i], &fragment, &fragment.checks[i]});
    }
}

void Grading::finish(FragmentRecord& fragment) {
    if (const auto problem = programs_.problems().find(fragment.name); problem != programs_.problems().end()) {
        fragment.verdict = problem->second.verdict;
        fragment.message = problem->second.message;
        fragment.trouble = problem->second.trouble;
        for (CheckRecord& check : fragment.checks) check.verdict = fragment.verdict;
        give_points(fragment);
    } else {
        fragment.verdict = Verdict::passed;
        for (const CheckRecord& check : fragment.checks) {
            fragment.verdict = worse(fragment.verdict, check.verdict);
            fragment.cpu_seconds += check.cpu_seconds;
        }
        give_points(fragment);
    }
    drop_guesses(fragment);
    fragment.warnings = programs_.warnings(fragment.name);
    fragment.finished = true;
}

/// What a check's record depends on, beside the grader: settings, and the source of its fragment.
std::string Grading::made_from(const std::string& fragment) const {
    return fmt::format("{} {} {} {} {} {}\n{}", settings_.seed, settings_.time_limit, settings_.pictures,
                       check_settings_.statistics.statistics, check_settings_.statistics.cap, record_.sandbox,
                       programs_.text(fragment));
}

/// What its calls show, where they are wrong; kept beside the checks' records, each in a file of its own.
Finding Grading::explain(const FragmentRecord& fragment) {
    const auto is_wrong = [](const CheckRecord& check) {
        return check.verdict == Verdict::failed || check.verdict == Verdict::not_finite ||
               check.verdict == Verdict::crashed;
    };
    const bool is_any_wrong = std::ranges::any_of(fragment.checks, is_wrong);
    const bool is_endless = std::ranges::count(fragment.checks, Trouble::endless, &CheckRecord::trouble) > 0;
    if (!settings_.explains || !programs_.has(fragment.name) || !(is_any_wrong || is_endless)) return {};
    const std::string key = fragment.name + ".finding", made = made_from(fragment.name);
    if (const auto before = settings_.build.kept.finding(key, made); before && !is_endless) return *before;
    const Programs::Linked& program = programs_.with({fragment.name});
    if (!program.errors.empty()) return {};
    const std::vector<Check>& checks = checks_.get();
    Finding finding;
    if (is_any_wrong && std::ranges::count(fragment.checks, Verdict::crashed, &CheckRecord::verdict) == 0)
        finding = find_cause(programs_, chain_, fragment.name, checks, settings_.seed,
                             std::ranges::count(fragment.checks, Verdict::not_finite, &CheckRecord::verdict) > 0);
    finding.fault = find_fault(programs_, program, chain_, fragment, checks, settings_.seed);
    if (is_endless)  // which another machine may not be slow enough for
        find_endless(programs_, programs_.with({}).program, chain_, fragment, checks, settings_.seed, finding);
    else
        settings_.build.kept.keep_finding(key, made, finding);
    return finding;
}

/// What an earlier grading has found, and what is open.
std::vector<Task> Grading::recall() {
    std::vector<Task> open;
    for (const Task& task : tasks_) {
        if (!programs_.has(task.check->fragment)) continue;
        if (auto before = settings_.build.kept.check(key_of(*task.check), made_from(task.check->fragment)))
            *task.record = std::move(*before), ++record_.reused;
        else
            open.push_back(task);
    }
    return open;
}

/// A program for each fragment with open checks, and the solution's. What does not link has no checks.
void Grading::link(std::vector<Task>& open) {
    std::set<std::string> names;
    for (const Task& task : open) names.insert(task.check->fragment);
    const std::vector<std::string> list(names.begin(), names.end());
    progress_.expect(Work::link, int(list.size()) - links_expected_);
    if (list.empty()) return;
    in_parallel(int(list.size()) + 1, settings_.build.jobs, [&](int i) {
        progress_.tell("linking");
        if (i == 0) {
            programs_.with({});
        } else {
            const std::string& name = list[std::size_t(i) - 1];
            if (const auto& errors = programs_.with({name}).errors; !errors.empty()) programs_.fails(name, errors);
            progress_.done(Work::link);
        }
    });
    std::erase_if(open, [&](const Task& task) { return !programs_.has(task.check->fragment); });
}

CheckRecord Grading::judge(const Task& task, Lane& lane, SolutionRunners& solutions) {
    const std::string key = key_of(*task.check);
    const fs::path meshes = chain_.source / "scenes";
    CheckSettings settings = check_settings_;
    settings.budget = &budgets_[task.check->fragment];
    settings.another = [&] {
        return std::make_unique<Runner>(programs_.with({task.check->fragment}).program, programs_.sandbox(), meshes,
                                        settings_.time_limit);
    };
    for (bool again = false;; again = true) try {
            Reference reference(*task.check, settings_.seed, solutions);
            const bool is_used = lane.runner != nullptr;
            auto runner = is_used ? std::move(lane.runner) : settings.another();
            CheckRecord record = run_check(*task.check, *runner, reference, settings);
            // who never answered may not even have started, and an earlier check may have broken what it left
            const bool is_doubtful = is_used || !runner->has_answered();
            if (record.verdict == Verdict::crashed && is_doubtful && !again) continue;
            if (is_measured(record)) lane.runner = std::move(runner);
            settings_.build.kept.keep_check(key, made_from(task.check->fragment), record);
            return record;
        } catch (const std::runtime_error& error) {
            if (again)
                throw std::runtime_error(fmt::format(
                    "{}: {}; it was tried twice. That is no verdict on the submission: expected a machine with "
                    "processes, memory, open files and room to spare; of a check that is being written, rows as "
                    "fragments.h declares them",
                    key, error.what()));
        }
}

void Grading::judge_all(const std::vector<Task>& open) {
    for (const Task& task : open) ++left_[task.check->fragment], budgets_[task.check->fragment];
    for (FragmentRecord& fragment : record_.fragments)
        if (left_[fragment.name] == 0) fragment.finding = explain(fragment), finish(fragment);
    if (settings_.partial) settings_.partial(record_);
    progress_.expect(Work::check, int(open.size()) - checks_expected_);
    if (open.empty()) return;
    SolutionRunners solutions(programs_.with({}).program, programs_.sandbox(), chain_.source / "scenes");
    std::vector<Lane> lanes = lanes_of(open);
    in_parallel(int(lanes.size()), settings_.build.jobs, [&](int i) {
        Lane& lane = lanes[std::size_t(i)];
        for (const Task& task : lane.tasks) judge_next(task, lane, solutions);
        lane.runner.reset();
    });
}

/// One check, and after a fragment's last one what its calls show.
void Grading::judge_next(const Task& task, Lane& lane, SolutionRunners& solutions) {
    check_interrupt();
    const std::string& fragment = task.check->fragment;
    progress_.tell(key_of(*task.check));
    CheckRecord record = blank_record(*task.check);
    bool late = false, is_last = false;
    {
        const std::scoped_lock lock(lock_);
        late = is_late(*task.fragment, *task.record);
    }
    if (late)
        leave_out(record);
    else
        record = judge(task, lane, solutions);
    {
        const std::scoped_lock lock(lock_);
        *task.record = std::move(record);
        is_last = --left_[fragment] == 0;
        if (is_last) leave_out_late(*task.fragment);
    }
    // nobody else writes to this fragment any more
    const Finding finding = is_last ? explain(*task.fragment) : Finding{};
    {
        const std::scoped_lock lock(lock_);
        if (is_last) task.fragment->finding = finding, finish(*task.fragment);
        if (settings_.partial) settings_.partial(record_);
    }
    progress_.done(Work::check);
}

void Grading::compile() {
    constexpr int checks_of_a_fragment = 3;  // about: they are not made yet
    std::set<std::string> wanted;
    for (const FragmentRecord& fragment : record_.fragments) wanted.insert(fragment.name);
    links_expected_ = programs_.to_compile(wanted);
    checks_expected_ = checks_of_a_fragment * links_expected_;
    progress_.expect(Work::compile, links_expected_);
    progress_.expect(Work::link, links_expected_);
    progress_.expect(Work::check, checks_expected_);
    programs_.compile(wanted);
}

Record Grading::run() {
    if (settings_.partial) settings_.partial(record_);
    compile();
    add_checks();
    std::vector<Task> open = recall();
    link(open);
    judge_all(open);
    return record_;
}

}  // namespace

Record grade_programs(Programs& programs, const Assignment& assignment, const Toolchain& chain,
                      const FutureChecks& checks, const GradingSettings& settings, Progress& progress) {
    return Grading(programs, assignment, chain, checks, settings, progress).run();
}

Record grade_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                        const FutureChecks& checks, const GradingSettings& settings) {
    const auto start = Clock::now();
    Progress progress(settings.progress);
    Programs programs(submission, chain, settings.build, progress);
    Record record = grade_programs(programs, assignment, chain, checks, settings, progress);
    record.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return record;
}

FutureChecks ready(std::vector<Check> checks) {
    std::promise<std::vector<Check>> made;
    made.set_value(std::move(checks));
    return made.get_future().share();
}

}  // namespace grade
