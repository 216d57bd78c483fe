#include "judging/grading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>

#include "build/compile.h"
#include "build/files.h"
#include "judging/judge_check.h"
#include "judging/mentions.h"
#include "judging/parallel.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// What a check needs of other fragments.
const std::vector<std::string> no_needs;

/// A check, where it stands in the record.
struct Task {
    const Check* check;
    FragmentRecord* fragment;
    CheckRecord* record;
};

/// Everything that one grading shares. The steps are below, in their order.
class Grading {
public:
    Grading(const Programs& programs, const Assignment& assignment, const Toolchain& chain,
            const std::vector<Check>& checks, const GradingSettings& settings, Progress& progress);

    Record run();

private:
    void judge_all();
    void judge_in_order();
    void draw();

    void judge(const Task& task);
    std::string made_from(const Task& task) const;
    void block(const Task& task, const std::vector<std::string>& by);
    void finish(FragmentRecord& fragment);

    const Programs& programs_;
    const Assignment& assignment_;
    const Toolchain& chain_;
    const GradingSettings& settings_;
    Progress& progress_;
    Record record_;
    std::vector<Task> tasks_;
    std::map<std::string, StoredCheck> stored_;
    CheckSettings check_settings_;
    std::mutex lock_;
};

Grading::Grading(const Programs& programs, const Assignment& assignment, const Toolchain& chain,
                 const std::vector<Check>& checks, const GradingSettings& settings, Progress& progress)
    : programs_(programs), assignment_(assignment), chain_(chain), settings_(settings), progress_(progress) {
    record_.submission = programs.submission();
    record_.title = assignment.title;
    record_.seed = settings.seed;
    record_.student_mode = settings.student;
    record_.sandbox = programs.sandbox().description;
    record_.toolchain = chain.description;
    record_.version = PENUMBRA_VERSION;

    check_settings_.seed = settings.seed;
    check_settings_.pictures = settings.pictures;
    check_settings_.statistics.statistics = settings.statistics > 0 ? settings.statistics : noisy_statistics(checks);
    check_settings_.statistics.cap = settings.replicates;

    for (const Fragment& fragment : assignment.fragments) {
        if (fragment.given || (!settings.only.empty() && !settings.only.contains(fragment.name))) continue;
        FragmentRecord record;
        record.name = fragment.name, record.part = fragment.part, record.max_points = fragment.points;
        for (const Check& check : checks)
            if (check.fragment == fragment.name) record.checks.push_back(blank_record(check));
        if (const auto problem = programs.problems().find(fragment.name); problem != programs.problems().end()) {
            record.verdict = problem->second.verdict;
            record.message = problem->second.message;
            record.finished = true;
            for (CheckRecord& check : record.checks) check.verdict = record.verdict;
        }
        record_.fragments.push_back(std::move(record));
    }
    for (FragmentRecord& fragment : record_.fragments)
        for (CheckRecord& check : fragment.checks) {
            const auto same = [&](const Check& c) { return c.fragment == fragment.name && c.name == check.name; };
            tasks_.push_back({&*std::ranges::find_if(checks, same), &fragment, &check});
        }
    if (settings.student) stored_ = read_references(chain.source / "scenes/reference");
}

void Grading::finish(FragmentRecord& fragment) {
    const std::scoped_lock lock(lock_);
    if (!fragment.checks.empty()) {
        fragment.verdict = Verdict::passed;
        for (const CheckRecord& check : fragment.checks) {
            fragment.verdict = worse(fragment.verdict, check.verdict);
            fragment.cpu_seconds += check.cpu_seconds;
            for (const std::string& by : check.blocked_by)
                if (std::ranges::count(fragment.blocked_by, by) == 0) fragment.blocked_by.push_back(by);
        }
        fragment.points = points_of(fragment);
    } else {
        fragment.message = "no check looks at this fragment";
    }
    fragment.finished = true;
    if (settings_.partial) settings_.partial(record_);
}

void Grading::block(const Task& task, const std::vector<std::string>& by) {
    task.record->verdict = Verdict::blocked;
    task.record->blocked_by = by;
    task.record->message =
        fmt::format("needs {}, which {} not pass yet", fmt::join(by, ", "), by.size() == 1 ? "does" : "do");
}

void Grading::judge(const Task& task) {
    const std::string& name = task.check->fragment;
    const std::string from = settings_.student ? made_from(task) : "";
    if (const auto before = settings_.kept.check(key_of(*task.check), from)) {
        *task.record = *before;
        const std::scoped_lock lock(lock_);
        ++record_.reused;
        return;
    }
    const fs::path meshes = chain_.source / "scenes";
    const fs::path& program = settings_.student ? programs_.together() : programs_.apart(name);
    // student code may write into its folder: each check gets one of its own
    const fs::path own = programs_.folder("runs/" + key_of(*task.check));
    fs::create_hard_link(program, own / "child");

    Reference reference;
    if (settings_.student) {
        if (const auto found = stored_.find(key_of(*task.check)); found != stored_.end())
            reference = Reference(found->second);
    } else {
        reference = Reference(*task.check, settings_.seed, programs_.solution(), programs_.sandbox(), meshes);
    }
    Runner runner(own / "child", programs_.sandbox(), meshes, settings_.time_limit);
    *task.record = judge_check(*task.check, runner, reference, check_settings_);
    settings_.kept.keep_check(key_of(*task.check), from, *task.record);
}

/// What a check's record depends on, in student mode, beside the grader: the settings, and the sources of its fragment
/// of those that it needs, and of those that any of these names. Others take no part in its experiment.
std::string Grading::made_from(const Task& task) const {
    std::string text = fmt::format("{} {} {} {} {} {}\n", settings_.seed, settings_.time_limit, settings_.pictures,
                                   check_settings_.statistics.statistics, check_settings_.statistics.cap,
                                   record_.sandbox);
    std::set<std::string> called(no_needs.begin(), no_needs.end()), all;
    called.insert(task.check->fragment);
    for (const auto& [name, object] : chain_.blank_objects) all.insert(name);
    for (const std::string& name :
         with_mentioned(called, all, [&](const std::string& fragment) { return programs_.source(fragment); })) {
        const std::string source = programs_.source(name);
        text += fmt::format("{} {}\n{}\n", name, source.size(), source);
    }
    return text;
}

/// Instructor: checks depend on nothing but their own fragment.
void Grading::judge_all() {
    std::vector<Task> open;
    std::map<std::string, int> left;
    for (const Task& task : tasks_)
        if (!task.fragment->finished) open.push_back(task), ++left[task.fragment->name];
    progress_.expect(int(open.size()));
    for (FragmentRecord& fragment : record_.fragments)
        if (!fragment.finished && fragment.checks.empty()) finish(fragment);
    in_parallel(int(open.size()), settings_.jobs, [&](int i) {
        const Task& task = open[std::size_t(i)];
        progress_.tell(key_of(*task.check));
        judge(task);
        bool last = false;
        {
            const std::scoped_lock lock(lock_);
            last = --left[task.fragment->name] == 0;
        }
        if (last) finish(*task.fragment);
        progress_.tell(key_of(*task.check), 1);
    });
}

/// Student: a fragment after all those that its checks need. Of fragments that need each other, the first of the
/// assignment goes first, and counts what is not judged yet as passing.
void Grading::judge_in_order() {
    const auto record_named = [&](const std::string& name) {
        const auto found = std::ranges::find(record_.fragments, name, &FragmentRecord::name);
        return found == record_.fragments.end() ? nullptr : &*found;
    };
    const auto open_needs = [&](const FragmentRecord& fragment) {
        for (const Task& task : tasks_)
            if (task.fragment == &fragment)
                for (const std::string& need : no_needs)
                    if (const FragmentRecord* other = record_named(need);
                        other && other != &fragment && !other->finished)
                        return true;
        return false;
    };
    progress_.expect(int(std::ranges::count_if(tasks_, [](const Task& task) { return !task.fragment->finished; })));
    while (true) {
        std::vector<FragmentRecord*> wave;
        FragmentRecord* first = nullptr;
        for (FragmentRecord& fragment : record_.fragments) {
            if (!!fragment.finished) continue;
            if (!first) first = &fragment;
            if (!open_needs(fragment)) wave.push_back(&fragment);
        }
        if (!first) return;
        if (wave.empty()) wave.push_back(first);

        std::vector<Task> open;
        for (const Task& task : tasks_) {
            if (std::ranges::count(wave, task.fragment) == 0) continue;
            std::vector<std::string> by;
            for (const std::string& need : no_needs) {
                const FragmentRecord* other = record_named(need);
                const bool given = assignment_.fragments[assignment_.place(need)].given;
                if (need == task.check->fragment || given) continue;
                // with --only, a fragment that is not graded counts as passing where it is there
                if (other ? other->finished && other->verdict != Verdict::passed : !programs_.has(need))
                    by.push_back(need);
            }
            if (by.empty()) open.push_back(task);
            else block(task, by), progress_.tell(key_of(*task.check), 1);
        }
        in_parallel(int(open.size()), settings_.jobs, [&](int i) {
            progress_.tell(key_of(*open[std::size_t(i)].check));
            judge(open[std::size_t(i)]);
            progress_.tell(key_of(*open[std::size_t(i)].check), 1);
        });
        for (FragmentRecord* fragment : wave) finish(*fragment);
    }
}

/// The submission's own picture, with all of its fragments.
void Grading::draw() {
    if (settings_.own_scene.empty()) return;
    record_.own_picture_scene = settings_.own_scene.filename().string();
    const auto text = read_text(settings_.own_scene);
    if (!text) throw std::runtime_error(settings_.own_scene.string() + ": cannot be read");
    const rt::Scene scene = rt::parse_scene(*text, settings_.own_scene.string());
    record_.own_picture_exposure = scene.exposure;

    progress_.tell("drawing the submission's own picture");
    for (const FragmentRecord& fragment : record_.fragments)
        if (fragment.verdict == Verdict::crashed || fragment.verdict == Verdict::timed_out)
            record_.left_out.push_back(fragment.name);
    const std::set<std::string> left_out(record_.left_out.begin(), record_.left_out.end());
    const fs::path program = left_out.empty() ? programs_.together() : programs_.together_without(left_out);
    Runner runner(program, programs_.sandbox(), settings_.own_scene.parent_path(), 3 * settings_.time_limit);
    constexpr double seconds = 6;
    auto outcome = runner.render({*text, 1, "sobol"}, settings_.seed, seconds);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) record_.own_picture_fault = fault->message;
    else record_.own_picture = std::move(std::get<rt::Image>(outcome));
}

Record Grading::run() {
    if (settings_.partial) settings_.partial(record_);
    if (settings_.student) judge_in_order();
    else judge_all();
    draw();
    return record_;
}

}  // namespace

BuildSettings build_settings(const GradingSettings& settings) {
    const bool together = settings.student || !settings.own_scene.empty();
    return {settings.only, !settings.student, together, settings.jobs, settings.trusted, settings.keep, settings.kept};
}

Record grade_programs(const Programs& programs, const Assignment& assignment, const Toolchain& chain,
                      const std::vector<Check>& checks, const GradingSettings& settings, Progress& progress) {
    return Grading(programs, assignment, chain, checks, settings, progress).run();
}

Record grade_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                        const std::vector<Check>& checks, const GradingSettings& settings) {
    const auto start = Clock::now();
    Progress progress(settings.progress);
    const Programs programs(submission, assignment, chain, build_settings(settings), progress);
    Record record = grade_programs(programs, assignment, chain, checks, settings, progress);
    record.wall_seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return record;
}

std::map<std::string, StoredCheck> make_references(
    const Toolchain& chain, const std::vector<Check>& checks, int replicates, int jobs,
    const std::function<void(int done, int all, const std::string& doing)>& progress) {
    const TemporaryFolder work;
    const Sandbox sandbox = find_sandbox(true);
    const fs::path program = work.path() / "child";
    std::vector<fs::path> objects;
    for (const auto& [name, object] : chain.solution_objects) objects.push_back(object);
    if (const auto errors = link_child(chain, objects, program); !errors.empty())
        throw std::runtime_error("the solution cannot be linked: " + errors);

    std::map<std::string, StoredCheck> all;
    std::mutex lock;
    in_parallel(int(checks.size()), jobs, [&](int i) {
        const Check& check = checks[std::size_t(i)];
        Reference live(check, student_seed, program, sandbox, chain.source / "scenes");
        StoredCheck stored;
        stored.exact = live.exact().value();
        stored.noisy = live.noisy().value();
        stored.cpu_seconds = live.cpu_seconds().value();
        const auto open = [](const Statistic& statistic) { return !statistic.truth && !statistic.exact; };
        if (std::ranges::any_of(check.statistics, open))
            for (int k = 0; k < replicates; ++k) stored.replicates.push_back(live.replicate(k).value());
        const std::scoped_lock guard(lock);
        all[key_of(check)] = std::move(stored);
        if (progress) progress(int(all.size()), int(checks.size()), key_of(check));
    });
    return all;
}

}  // namespace grade
