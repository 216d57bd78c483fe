#include "stress/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

#include "programs/parallel.h"
#include "programs/runner.h"

namespace grade::stress {

namespace {

constexpr std::uint64_t calls_of_a_request = 1u << 17;  // well within the time limit, also on a busy machine

struct Kind {
    Swarm swarm;
    CountRecord record;
};

std::vector<Kind> kinds(double rays) {
    return {
        {Swarm::mesh, {"mesh", "rays from within a closed mesh that get out", {"hit_triangle"}, rays}},
        {Swarm::leave_sphere,
         {"leave_sphere", "rays that leave a sphere and meet it", {"shadow_ray", "hit_sphere"}, std::ceil(rays * 0.8)}},
        {Swarm::leave_quad,
         {"leave_quad", "rays that leave a quad and meet it", {"shadow_ray", "hit_quad"}, std::ceil(rays * 0.6)}},
        {Swarm::leave_triangle,
         {"leave_triangle",
          "rays that leave a triangle and meet it",
          {"shadow_ray", "hit_triangle"},
          std::ceil(rays * 0.6)}}};
}

bool is_fault(Swarm kind, double answer) { return kind == Swarm::mesh ? !(answer < rt::inf) : answer != rt::inf; }

/// Why a count cannot be made; empty: it can.
std::string complaint_about(const Programs& programs, const std::vector<std::string>& fragments) {
    std::string last;
    for (const std::string& name : fragments)
        if (const std::string complaint = programs.complaint(name); !complaint.empty()) last = name + ": " + complaint;
    return last;
}

/// One count, by several workers that take the next piece each, until all are done or one breaks down.
void count_faults(Swarm kind, CountRecord& record, Programs& programs, const fs::path& meshes,
                  const StressSettings& settings) {
    const fs::path program = programs.must_link({record.fragments.begin(), record.fragments.end()});
    const auto total = std::uint64_t(record.calls), requests = (total + calls_of_a_request - 1) / calls_of_a_request;
    const int cores = std::max(1, int(std::thread::hardware_concurrency())),
              workers = std::min(int(requests), settings.build.jobs > 0 ? settings.build.jobs : cores);
    std::mutex lock;
    std::uint64_t next = 0, done = 0;
    record.calls = 0;
    in_parallel(workers, workers, [&](int worker) {
        Runner runner(programs.copy_for(fmt::format("{}{}", record.name, worker), program), programs.sandbox(), meshes,
                      settings.time_limit);
        while (true) {
            std::uint64_t mine = 0;
            {
                const std::scoped_lock guard(lock);
                if (next == requests || !record.message.empty()) return;
                mine = next++;
            }
            const std::uint64_t first = mine * calls_of_a_request;
            const auto outcome = runner.swarm({kind, 1, first, std::min(calls_of_a_request, total - first)});
            const std::scoped_lock guard(lock);
            if (const Fault* fault = std::get_if<Fault>(&outcome)) {
                record.message = fault->message;
                return;
            }
            const auto& answers = std::get<std::vector<double>>(outcome);
            record.calls += double(answers.size());
            record.faults += double(std::ranges::count_if(answers, [&](double x) { return is_fault(kind, x); }));
            record.seconds += runner.seconds();
            if (settings.progress) settings.progress(int(++done), int(requests), record.name);
        }
    });
}

}  // namespace

std::vector<CountRecord> big_counts(Programs& programs, const fs::path& meshes, const StressSettings& settings) {
    std::vector<CountRecord> all;
    for (auto& [kind, record] : kinds(settings.rays)) {
        record.message = complaint_about(programs, record.fragments);
        if (record.message.empty())
            count_faults(kind, record, programs, meshes, settings);
        else
            record.calls = 0;
        all.push_back(record);
    }
    return all;
}

}  // namespace grade::stress
