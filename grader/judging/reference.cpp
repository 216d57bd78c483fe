#include "judging/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace grade {

namespace {

std::vector<double> all_measured(const Check& check, const Observation& observation) {
    std::vector<double> values;
    for (const Statistic& statistic : check.statistics) values.push_back(measured(statistic, observation));
    return values;
}

}  // namespace

void add_picture(rt::Image& mean, const rt::Image& next, std::size_t count) {
    if (count == 0)
        mean = next;
    else
        for (std::size_t k = 0; k < mean.pixels.size(); ++k)
            mean.pixels[k] += (next.pixels[k] - mean.pixels[k]) / double(count + 1);
}

std::unique_ptr<Runner> SolutionRunners::take() {
    constexpr double patience = 120;  // s
    {
        const std::scoped_lock lock(lock_);
        if (auto& own = free_[std::this_thread::get_id()]) return std::move(own);
    }
    return std::make_unique<Runner>(program_, sandbox_, meshes_, patience);
}

void SolutionRunners::give_back(std::unique_ptr<Runner> runner) {
    const std::scoped_lock lock(lock_);
    free_[std::this_thread::get_id()] = std::move(runner);
}

Reference::~Reference() {
    if (runner_) runners_.give_back(std::move(runner_));
}

Observation Reference::run(std::uint64_t with_seed) {
    if (!runner_) runner_ = runners_.take();
    auto outcome = observe(*runner_, check_, with_seed);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) {
        runner_.reset();
        throw std::runtime_error(fmt::format("check {}: the solution itself: {}", check_.name, fault->message));
    }
    cpu_seconds_ = std::min(cpu_seconds_, runner_->seconds());
    return std::move(std::get<Observation>(outcome));
}

const Observation& Reference::with_seed_of_submission(int which) {
    while (int(own_.size()) <= which)
        own_.push_back(run(replicate_seed(seed_, check_, Stream::submission, int(own_.size()))));
    return own_[std::size_t(which)];
}

std::vector<double> Reference::exact() { return all_measured(check_, with_seed_of_submission(0)); }

std::vector<double> Reference::replicate(int which) {
    return all_measured(check_, run(replicate_seed(seed_, check_, Stream::reference, which)));
}

bool Reference::noisy() {
    with_seed_of_submission(1);
    return differs(own_[0], own_[1]);
}

double Reference::cpu_seconds() {
    with_seed_of_submission(0);
    return cpu_seconds_;
}

const rt::Image& Reference::image(int which) { return with_seed_of_submission(which).image; }

std::string Reference::trace(rt::ivec2 pixel) {
    if (!runner_) runner_ = runners_.take();
    auto outcome = runner_->trace(std::get<Render>(check_.experiment),
                                  replicate_seed(seed_, check_, Stream::submission, 0), pixel);
    if (std::holds_alternative<Fault>(outcome)) {
        runner_.reset();
        return {};
    }
    return std::move(std::get<std::string>(outcome));
}

rt::Image Reference::picture(int replicates) {
    rt::Image mean;
    for (int i = 0; i < replicates; ++i) add_picture(mean, image(i), std::size_t(i));
    return mean;
}

}  // namespace grade
