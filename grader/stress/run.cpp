#include "stress/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "build/runner.h"
#include "judging/parallel.h"
#include "stress/count.h"
#include "stress/family_programs.h"

namespace grade {

namespace {

/// No answer came back.
struct Broken : std::runtime_error {
    bool timed_out;

    explicit Broken(const Fault& fault)
        : std::runtime_error(fault.message), timed_out(fault.verdict == Verdict::timed_out) {}
};

template <class Value>
Value value_of(Outcome<Value> outcome) {
    if (const Fault* fault = std::get_if<Fault>(&outcome)) throw Broken(*fault);
    return std::move(std::get<Value>(outcome));
}

/// A family on one program. A decade without an answer fails, and the next one starts a new process; after one that did
/// not end, those beyond it are not tried.
void sweep_family(FamilyRecord& record, const FamilyPrograms& programs, const fs::path& program, const Sandbox& sandbox,
                  const fs::path& meshes, double time_limit, double& cpu_seconds) {
    const Family& family = *record.family;
    std::unique_ptr<Runner> runner;
    const auto alive = [&]() -> Runner& {
        if (!runner)
            runner = std::make_unique<Runner>(programs.copy_for(family.name, program), sandbox, meshes, time_limit);
        return *runner;
    };
    const Asker ask{
        [&](const std::string& fragment, const Rows& rows) {
            Rows out = value_of(alive().probe(fragment, rows));
            cpu_seconds += alive().seconds();
            return out;
        },
        [&](const std::string& scene, int samples) {
            rt::Image image = value_of(alive().render({scene, samples, "random"}, 1));
            cpu_seconds += alive().seconds();
            return image;
        }};

    // outwards from the mildest
    std::vector<int> order = family.decades;
    std::ranges::stable_sort(order, {}, [&](int decade) { return std::abs(decade - family.mildest()); });
    bool stuck_below = false, stuck_above = false;
    for (const int decade : order) {
        DecadeRecord result{decade, rt::inf, {}, false};
        bool& stuck = decade < family.mildest() ? stuck_below : stuck_above;
        if (!stuck) try {
                Generator random = stream(std::uint64_t(std::int64_t(decade)), family.name);
                result.error = worse_error(0, family.measure(std::pow(10.0, decade), random, ask));
            } catch (const Broken& broken) {
                result.message = broken.what();
                stuck = broken.timed_out;
                runner.reset();
            } catch (const std::out_of_range&) {
                result.message = "the answer is too short";
            }
        else result.message = "not tried: a milder one did not end";
        result.passed = result.error <= family.allowed(decade);
        record.decades.push_back(std::move(result));
    }
    std::ranges::sort(record.decades, {}, &DecadeRecord::decade);
    record.reach = reach_of(family, record.decades);
}

}  // namespace

StressRecord stress_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                               const StressSettings& settings) {
    const Sandbox sandbox = find_sandbox(settings.trusted);
    StressRecord record;
    record.submission = submission.name;
    record.toolchain = chain.description;
    record.version = PENUMBRA_VERSION;
    record.sandbox = sandbox.description;
    record.student_mode = settings.student;

    const auto stored = read_solution_reach((chain.source / "scenes/reference/stress.json").string());
    std::set<std::string> fragments;
    for (const Family& family : all_families()) {
        const std::string& about = family.fragments.front();
        if (!settings.only.empty() && !settings.only.contains(family.name) && !settings.only.contains(about)) continue;
        FamilyRecord one;
        one.family = &family;
        if (const auto found = stored.find(family.name); found != stored.end()) one.solution = found->second;
        record.families.push_back(std::move(one));
        fragments.insert(family.fragments.begin(), family.fragments.end());
    }
    if (settings.rays > 0) fragments.insert({"shadow_ray", "hit_sphere", "hit_quad", "hit_triangle"});
    std::ranges::stable_sort(record.families, {},
                             [&](const FamilyRecord& one) { return assignment.place(one.family->fragments.front()); });
    FamilyPrograms programs(submission, chain, sandbox, settings.student);
    if (settings.progress) settings.progress(0, int(record.families.size()), "compiling");
    programs.compile(fragments, settings.jobs);

    if (settings.rays > 0) record.counts = big_counts(programs, sandbox, chain.source / "scenes", settings);
    std::mutex lock;
    int done = 0;
    in_parallel(int(record.families.size()), settings.jobs, [&](int i) {
        FamilyRecord& one = record.families[std::size_t(i)];
        const auto& needed = one.family->fragments;
        double seconds = 0;
        for (const std::string& name : needed)
            if (one.message.empty() && (settings.student || name == needed.front()))
                one.message = programs.complaint(name);
        one.started = one.message.empty();
        if (one.started)
            sweep_family(one, programs, programs.with({needed.begin(), needed.end()}), sandbox, chain.source / "scenes",
                         settings.time_limit, seconds);
        const std::scoped_lock guard(lock);
        record.cpu_seconds += seconds;
        if (settings.progress) settings.progress(++done, int(record.families.size()), one.family->name);
    });
    return record;
}

}  // namespace grade
