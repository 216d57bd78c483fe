#include "judging/experiment.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstring>
#include <exception>
#include <limits>

#include "diagnosis/diagnosis.h"
#include "rt/sampler.h"
#include "statistics/image_fault.h"

namespace grade {

namespace {

std::optional<Fault> probe_fault(const std::string& fragment, const Rows& inputs, const Rows& outputs) {
    for (std::size_t i = 0; i < outputs.size(); ++i)
        if (std::ranges::any_of(outputs[i], [](double x) { return std::isnan(x); })) {
            const Row shown(inputs[i].begin(), inputs[i].begin() + std::min<std::ptrdiff_t>(std::ssize(inputs[i]), 16));
            return Fault{
                Verdict::not_finite,
                fragment +
                    " returned nan: look for 0/0, the root of a negative number, or the direction of a vector "
                    "of length 0; see \"" +
                    std::string(numbers_section) + "\"",
                fmt::format("for ({:.6g}{})", fmt::join(shown, ", "), shown.size() < inputs[i].size() ? ", ..." : ""),
                Trouble::not_a_number};
        }
    return std::nullopt;
}

}  // namespace

std::string key_of(const Check& check) { return check.fragment + "." + check.name; }

std::uint64_t replicate_seed(std::uint64_t grading_seed, const Check& check, Stream stream, int replicate) {
    using rt::combine;
    std::uint64_t state = combine(grading_seed, 0);
    for (const char c : key_of(check)) state = combine(state ^ static_cast<unsigned char>(c), 0);
    return combine(combine(state ^ std::uint64_t(stream), 0) + std::uint64_t(replicate), 0);
}

Outcome<Observation> observe(Runner& runner, const Check& check, std::uint64_t seed) {
    Observation observation;
    if (const auto* probe = std::get_if<Probe>(&check.experiment)) {
        Generator generator(seed);
        observation.inputs = probe->inputs(generator);
        auto outcome = runner.probe(probe->fragment, observation.inputs);
        if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;
        observation.outputs = std::move(std::get<Rows>(outcome));
        if (const auto fault = probe_fault(probe->fragment, observation.inputs, observation.outputs)) return *fault;
        return observation;
    }
    auto outcome = runner.render(std::get<Render>(check.experiment), seed);
    if (const Fault* fault = std::get_if<Fault>(&outcome)) return *fault;
    observation.image = std::move(std::get<rt::Image>(outcome));
    observation.rays = runner.rays_of_each_kind();
    if (const auto fault = image_fault(observation.image, observation.image.width, observation.image.height))
        return Fault{fault->verdict, fault->words, {}, fault->trouble};
    return observation;
}

bool is_same(const Observation& a, const Observation& b) {
    const auto same_rows = [](const Rows& x, const Rows& y) {
        if (x.size() != y.size()) return false;
        for (std::size_t i = 0; i < x.size(); ++i)
            if (x[i].size() != y[i].size() || std::memcmp(x[i].data(), y[i].data(), x[i].size() * sizeof(double)) != 0)
                return false;
        return true;
    };
    return is_same(a.image, b.image) && same_rows(a.outputs, b.outputs);
}

bool differs(const Observation& a, const Observation& b) {
    const auto apart = [](double x, double y) {
        if (!std::isfinite(x) || !std::isfinite(y)) return x != y && !(std::isnan(x) && std::isnan(y));
        return std::abs(x - y) > 1e-6 * std::max(std::abs(x), std::abs(y));
    };
    for (std::size_t i = 0; i < std::min(a.image.pixels.size(), b.image.pixels.size()); ++i)
        for (int c = 0; c < 3; ++c)
            if (apart(a.image.pixels[i][c], b.image.pixels[i][c])) return true;
    for (std::size_t i = 0; i < std::min(a.outputs.size(), b.outputs.size()); ++i)
        for (std::size_t k = 0; k < std::min(a.outputs[i].size(), b.outputs[i].size()); ++k)
            if (apart(a.outputs[i][k], b.outputs[i][k])) return true;
    return false;
}

double measured(const Statistic& statistic, const Observation& observation) try {
    return statistic.measure(observation);
} catch (const std::exception&) {
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace grade
