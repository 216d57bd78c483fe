#include "stress/run.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "programs/parallel.h"
#include "programs/programs.h"
#include "programs/runner.h"

namespace grade::stress {

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

/// The decades of a family on one program. A decade without an answer fails, and the next one starts a new process;
/// after one that did not end, those beyond it are not tried.
std::vector<DecadeRecord> sweep_family(const Family& family, const Programs& programs, const fs::path& program,
                                       const std::string& name, const fs::path& meshes, double time_limit,
                                       double& cpu_seconds) {
    std::vector<DecadeRecord> decades;
    std::unique_ptr<Runner> runner;
    const auto alive = [&]() -> Runner& {
        if (!runner)
            runner = std::make_unique<Runner>(programs.copy_for(name, program), programs.sandbox(), meshes, time_limit);
        return *runner;
    };
    const Asker ask{[&](const std::string& fragment, const Rows& rows) {
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
    std::vector<int> order = family.demand.decades;
    std::ranges::stable_sort(order, {}, [&](int decade) { return std::abs(decade - family.demand.mildest()); });
    bool stuck_below = false, stuck_above = false;
    for (const int decade : order) {
        DecadeRecord result{decade, rt::inf, {}, false};
        bool& stuck = decade < family.demand.mildest() ? stuck_below : stuck_above;
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
        else
            result.message = "not tried: a milder one did not end";
        result.passed = result.error <= family.demand.allowed(decade);
        decades.push_back(std::move(result));
    }
    std::ranges::sort(decades, {}, &DecadeRecord::decade);
    return decades;
}

/// The families that are asked for, in the order of the assignment.
std::vector<FamilyRecord> chosen_families(const StressSettings& settings, const Assignment& assignment) {
    std::vector<FamilyRecord> chosen;
    for (const Family& family : all_families()) {
        const auto asked = [&](const std::string& name) { return is_named(family, name); };
        if (!settings.only.empty() && std::ranges::none_of(settings.only, asked)) continue;
        chosen.emplace_back().family = &family;
    }
    std::ranges::stable_sort(chosen, {},
                             [&](const FamilyRecord& one) { return assignment.place(one.family->fragments.front()); });
    return chosen;
}

/// Returns the CPU time of the submission's program.
double run_family(FamilyRecord& one, Programs& programs, const fs::path& meshes, double time_limit) {
    const auto& needed = one.family->fragments;
    const auto& [program, errors] = programs.with({needed.begin(), needed.end()});
    one.message = programs.complaint(needed.front());
    if (one.message.empty() && !errors.empty()) one.message = "did not build: " + errors;
    one.started = one.message.empty();
    const auto sweep = [&](const fs::path& of, const std::string& name, double& spent) {
        return sweep_family(*one.family, programs, of, name, meshes, time_limit, spent);
    };
    double seconds = 0, of_solution = 0;
    if (one.started) {
        one.decades = sweep(program, one.family->name, seconds);
        one.reach = reach_of(*one.family, one.decades);
    }
    const fs::path solution = programs.with({}).program;
    one.solution = one.started && program == solution
                       ? one.reach
                       : reach_of(*one.family, sweep(solution, one.family->name + "-solution", of_solution));
    return seconds;
}

}  // namespace

bool is_named(const Family& family, const std::string& name) {
    return family.name == name || family.fragments.front() == name;
}

StressRecord stress_submission(const Submission& submission, const Assignment& assignment, const Toolchain& chain,
                               const StressSettings& settings) {
    const fs::path meshes = chain.source / "scenes";
    Progress silent({});
    Programs programs(submission, chain, settings.build, silent);
    StressRecord record{.submission = submission.name,
                        .toolchain = chain.description,
                        .version = PENUMBRA_VERSION,
                        .sandbox = programs.sandbox().description,
                        .families = chosen_families(settings, assignment)};

    std::set<std::string> fragments;
    for (const FamilyRecord& one : record.families)
        fragments.insert(one.family->fragments.begin(), one.family->fragments.end());
    if (settings.rays > 0) fragments.insert({"shadow_ray", "hit_sphere", "hit_quad", "hit_triangle"});
    const int all = int(record.families.size());
    const auto tell = [&](int done, const std::string& what) {
        if (settings.progress) settings.progress(done, all, what);
    };
    tell(0, "compiling");
    programs.compile(fragments);

    if (settings.rays > 0) record.counts = big_counts(programs, meshes, settings);
    std::mutex lock;
    int done = 0;
    in_parallel(all, settings.build.jobs, [&](int i) {
        FamilyRecord& one = record.families[std::size_t(i)];
        const double seconds = run_family(one, programs, meshes, settings.time_limit);
        const std::scoped_lock guard(lock);
        record.cpu_seconds += seconds;
        tell(++done, one.family->name);
    });
    return record;
}

}  // namespace grade::stress
