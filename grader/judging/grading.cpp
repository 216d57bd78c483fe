#include "judging/grading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <mutex>

#include "build/code_only.h"
#include "build/compile.h"
#include "build/files.h"
#include "judging/judge_check.h"
#include "judging/parallel.h"
#include "rt/scene_reader.h"

namespace grade {

namespace {

/// A check, where it stands in the record.
struct Task {
    const Check* check;
    FragmentRecord* fragment;
    CheckRecord* record;
};

/// Everything that one grading shares. The steps are below, in their order.
class Grading {
public:
    Grading(const Submission& submission, const Assignment& assignment, const Toolchain& chain, const std::vector<Check>& checks,
            const GradingSettings& settings);

    Record run();

private:
    void compile();
    void link_each();
    void link_together();
    void judge_all();
    void judge_in_order();
    void draw();

    void judge(const Task& task);
    void block(const Task& task, const std::vector<std::string>& by);
    void finish(FragmentRecord& fragment);
    void not_built(FragmentRecord& fragment, const std::string& message);
    void tell(const std::string& doing, int steps);

    fs::path folder(const std::string& name) const;
    std::vector<fs::path> objects(const std::string& of, bool own_others) const;
    bool ready(const FragmentRecord& fragment) const { return !fragment.finished && built_.contains(fragment.name); }

    const Submission& submission_;
    const Assignment& assignment_;
    const Toolchain& chain_;
    const std::vector<Check>& checks_;
    const GradingSettings& settings_;
    TemporaryFolder temporary_;
    fs::path work_;
    Sandbox sandbox_;
    Record record_;
    std::vector<Task> tasks_;
    std::map<std::string, fs::path> built_;     // objects of the submission's fragments
    std::map<std::string, fs::path> programs_;  // children, by fragment
    fs::path solution_program_, own_program_;
    std::map<std::string, StoredCheck> stored_;
    CheckSettings check_settings_;
    Clock::time_point start_ = Clock::now();
    std::mutex lock_;
    int done_ = 0, all_ = 0;
};

Grading::Grading(const Submission& submission, const Assignment& assignment, const Toolchain& chain, const std::vector<Check>& checks,
                 const GradingSettings& settings)
    : submission_(submission), assignment_(assignment), chain_(chain), checks_(checks), settings_(settings) {
    work_ = settings.keep.empty() ? temporary_.path() : fs::absolute(settings.keep);
    fs::create_directories(work_);
    sandbox_ = find_sandbox(settings.trusted);

    record_.submission = submission.name;
    record_.title = assignment.title;
    record_.seed = settings.seed;
    record_.student_mode = settings.student;
    record_.sandbox = sandbox_.description;
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
        record_.fragments.push_back(std::move(record));
    }
    for (FragmentRecord& fragment : record_.fragments)
        for (CheckRecord& check : fragment.checks) {
            const auto same = [&](const Check& c) { return c.fragment == fragment.name && c.name == check.name; };
            tasks_.push_back({&*std::ranges::find_if(checks, same), &fragment, &check});
        }
    if (settings.student) stored_ = read_references(chain.source / "scenes/reference");
}

fs::path Grading::folder(const std::string& name) const {
    const fs::path path = work_ / name;
    fs::remove_all(path);
    fs::create_directories(path);
    return path;
}

void Grading::tell(const std::string& doing, int steps) {
    const std::scoped_lock lock(lock_);
    done_ += steps;
    if (settings_.progress) settings_.progress(done_, all_, doing);
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

void Grading::not_built(FragmentRecord& fragment, const std::string& message) {
    const std::scoped_lock lock(lock_);
    fragment.verdict = Verdict::did_not_build;
    fragment.message = message;
    fragment.finished = true;
    for (CheckRecord& check : fragment.checks) check.verdict = Verdict::did_not_build;
    built_.erase(fragment.name);
    if (settings_.partial) settings_.partial(record_);
}

/// Each fragment that is there and more than the blank becomes an object. In student mode, and for the submission's own
/// picture, those that are not graded are needed as well.
void Grading::compile() {
    struct Source {
        std::string name;
        const std::string* text;
        FragmentRecord* record;
    };
    std::vector<Source> sources;
    for (const Fragment& fragment : assignment_.fragments) {
        const auto found = std::ranges::find(record_.fragments, fragment.name, &FragmentRecord::name);
        FragmentRecord* record = found == record_.fragments.end() ? nullptr : &*found;
        const auto text = submission_.texts.find(fragment.name);
        const bool there = text != submission_.texts.end();
        if (there && !is_blank(text->second, chain_.blanks / (fragment.name + ".cpp")) && !fragment.given) {
            if (record || settings_.student || !settings_.own_scene.empty()) sources.push_back({fragment.name, &text->second, record});
            continue;
        }
        if (!record) continue;
        record->verdict = Verdict::not_started;
        record->finished = true;
        for (CheckRecord& check : record->checks) check.verdict = Verdict::not_started;
        const auto complaint = submission_.complaints.find(fragment.name);
        record->message = complaint != submission_.complaints.end() ? fmt::format("{}.cpp is {}", fragment.name, complaint->second)
                          : there                                   ? fmt::format("fill in {}{}.cpp", submission_.folder, fragment.name)
                                  : fmt::format("{}{}.cpp is not in the submission", submission_.folder, fragment.name);
    }
    all_ += int(sources.size());
    in_parallel(int(sources.size()), settings_.jobs, [&](int i) {
        const Source& source = sources[std::size_t(i)];
        const Compiled compiled = compile_fragment(chain_, sandbox_, source.name, *source.text,
                                                   submission_.folder + source.name + ".cpp", folder("objects/" + source.name));
        if (compiled.good) {
            const std::scoped_lock lock(lock_);
            built_[source.name] = compiled.object;
        } else if (source.record) {
            not_built(*source.record, compiled.message);
        }
        tell("compiling " + source.name, 1);
    });
}

/// One object for each fragment: `of` from the submission, and the others from the solution or, with own_others, from the
/// submission as far as it has them.
std::vector<fs::path> Grading::objects(const std::string& of, bool own_others) const {
    std::vector<fs::path> list;
    for (const auto& [name, symbol] : chain_.symbols) {
        const auto own = built_.find(name);
        const auto& others = own_others ? chain_.blank_objects : chain_.solution_objects;
        if (own != built_.end() && (own_others || name == of)) list.push_back(own->second);
        else if (const auto other = others.find(name); other != others.end()) list.push_back(other->second);
    }
    return list;
}

/// Instructor: one program for each fragment, and one of the solution alone.
void Grading::link_each() {
    std::vector<FragmentRecord*> fragments;
    for (FragmentRecord& fragment : record_.fragments)
        if (ready(fragment)) fragments.push_back(&fragment);
    if (fragments.empty()) return;
    all_ += int(fragments.size()) + 1;
    for (FragmentRecord* fragment : fragments) programs_[fragment->name];  // no insertion while threads run
    in_parallel(int(fragments.size()) + 1, settings_.jobs, [&](int i) {
        if (i == 0) {
            solution_program_ = folder("programs/solution") / "child";
            if (const auto errors = link_child(chain_, objects("", false), solution_program_); !errors.empty())
                throw std::runtime_error("the solution cannot be linked: " + errors);
        } else {
            FragmentRecord& fragment = *fragments[std::size_t(i) - 1];
            const fs::path program = folder("programs/" + fragment.name) / "child";
            std::vector<fs::path> parts;
            {
                const std::scoped_lock lock(lock_);
                parts = objects(fragment.name, false);
            }
            if (const auto errors = link_child(chain_, parts, program); !errors.empty()) not_built(fragment, errors);
            else programs_.at(fragment.name) = program;
        }
        tell("linking", 1);
    });
}

/// Student, and the submission's own picture: one program with all that is there.
void Grading::link_together() {
    own_program_ = folder("programs/own") / "child";
    if (link_child(chain_, objects("", true), own_program_).empty()) return;

    // one of them does not go with the framework: leave out those that do not even alone
    const auto candidates = built_;
    for (const auto& [name, object] : candidates) {
        built_ = {{name, object}};
        const std::string errors = link_child(chain_, objects("", true), own_program_);
        built_ = candidates;
        if (errors.empty()) continue;
        const auto record = std::ranges::find(record_.fragments, name, &FragmentRecord::name);
        if (record != record_.fragments.end() && !record->finished) not_built(*record, errors);
        built_.erase(name);
    }
    if (const auto errors = link_child(chain_, objects("", true), own_program_); !errors.empty())
        throw std::runtime_error("the submission's fragments cannot be linked with each other: " + errors);
}

void Grading::block(const Task& task, const std::vector<std::string>& by) {
    task.record->verdict = Verdict::blocked;
    task.record->blocked_by = by;
    task.record->message = fmt::format("needs {}, which {} not pass yet", fmt::join(by, ", "), by.size() == 1 ? "does" : "do");
}

void Grading::judge(const Task& task) {
    const std::string& name = task.check->fragment;
    const fs::path meshes = chain_.source / "scenes";
    const fs::path& program = settings_.student ? own_program_ : programs_.at(name);
    // student code may write into its folder: each check gets one of its own
    const fs::path own = folder("runs/" + key_of(*task.check));
    fs::create_hard_link(program, own / "child");

    Reference reference;
    if (settings_.student) {
        if (const auto found = stored_.find(key_of(*task.check)); found != stored_.end()) reference = Reference(found->second);
    } else {
        reference = Reference(*task.check, settings_.seed, solution_program_, sandbox_, meshes);
    }
    Runner runner(own / "child", sandbox_, meshes, settings_.time_limit);
    *task.record = judge_check(*task.check, runner, reference, check_settings_);
}

/// Instructor: checks depend on nothing but their own fragment.
void Grading::judge_all() {
    std::vector<Task> open;
    std::map<std::string, int> left;
    for (const Task& task : tasks_)
        if (ready(*task.fragment)) open.push_back(task), ++left[task.fragment->name];
    all_ += int(open.size());
    for (FragmentRecord& fragment : record_.fragments)
        if (ready(fragment) && fragment.checks.empty()) finish(fragment);
    in_parallel(int(open.size()), settings_.jobs, [&](int i) {
        const Task& task = open[std::size_t(i)];
        tell(task.check->fragment + ": " + task.check->name, 0);
        judge(task);
        bool last = false;
        {
            const std::scoped_lock lock(lock_);
            last = --left[task.fragment->name] == 0;
        }
        if (last) finish(*task.fragment);
        tell(task.check->fragment + ": " + task.check->name, 1);
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
                for (const std::string& need : task.check->needs)
                    if (const FragmentRecord* other = record_named(need); other && other != &fragment && !other->finished) return true;
        return false;
    };
    for (const Task& task : tasks_) all_ += ready(*task.fragment);
    while (true) {
        std::vector<FragmentRecord*> wave;
        FragmentRecord* first = nullptr;
        for (FragmentRecord& fragment : record_.fragments) {
            if (!ready(fragment)) continue;
            if (!first) first = &fragment;
            if (!open_needs(fragment)) wave.push_back(&fragment);
        }
        if (!first) return;
        if (wave.empty()) wave.push_back(first);

        std::vector<Task> open;
        for (const Task& task : tasks_) {
            if (std::ranges::count(wave, task.fragment) == 0) continue;
            std::vector<std::string> by;
            for (const std::string& need : task.check->needs) {
                const FragmentRecord* other = record_named(need);
                const bool given = assignment_.fragments[assignment_.place(need)].given;
                if (need == task.check->fragment || given) continue;
                // with --only, a fragment that is not graded counts as passing where it is there
                if (other ? other->finished && other->verdict != Verdict::passed : !built_.contains(need)) by.push_back(need);
            }
            if (by.empty()) open.push_back(task);
            else block(task, by), tell(task.check->fragment, 1);
        }
        in_parallel(int(open.size()), settings_.jobs, [&](int i) {
            tell(open[std::size_t(i)].check->fragment + ": " + open[std::size_t(i)].check->name, 0);
            judge(open[std::size_t(i)]);
            tell(open[std::size_t(i)].check->fragment + ": " + open[std::size_t(i)].check->name, 1);
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

    tell("drawing the submission's own picture", 0);
    for (const FragmentRecord& fragment : record_.fragments)
        if (fragment.verdict == Verdict::crashed || fragment.verdict == Verdict::timed_out) {
            built_.erase(fragment.name);
            record_.left_out.push_back(fragment.name);
        }
    link_together();
    Runner runner(own_program_, sandbox_, settings_.own_scene.parent_path(), 3 * settings_.time_limit);
    constexpr double seconds = 6;
    auto outcome = runner.render({*text, 1, "sobol"}, settings_.seed, seconds);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) record_.own_picture_fault = fault->message;
    else record_.own_picture = std::move(std::get<rt::Image>(outcome));
}

Record Grading::run() {
    compile();
    if (settings_.partial) settings_.partial(record_);
    if (!settings_.student) link_each();
    if (settings_.student) {
        link_together();
        judge_in_order();
    } else {
        judge_all();
    }
    draw();
    record_.wall_seconds = std::chrono::duration<double>(Clock::now() - start_).count();
    return record_;
}

}  // namespace

Record grade_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                        const std::vector<Check>& checks, const GradingSettings& settings) {
    return Grading(submission, assignment, chain, checks, settings).run();
}

std::map<std::string, StoredCheck> make_references(const Toolchain& chain, const std::vector<Check>& checks, int replicates, int jobs,
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
