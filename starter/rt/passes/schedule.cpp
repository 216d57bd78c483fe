#include "rt/passes/schedule.h"

#include <algorithm>
#include <bit>

namespace rt {
namespace {

constexpr std::uint64_t enough_to_judge = 16;        // samples behind an estimate of the error that ends the rendering
constexpr int passes_in_time = 12;                   // at least
constexpr int largest_pass = 1 << 16;                // samples: one pixel's are a worker's, all at once
constexpr std::uint64_t longest_sequence = 1 << 30;  // samples, then another one begins: indices are 32 bits

}  // namespace

int next_pass(const Goals& limits, const SoFar& so_far) {
    if (so_far.samples == 0) return 1;
    if (so_far.rmse <= limits.error && so_far.samples >= enough_to_judge) return 0;

    const Real samples = Real(so_far.samples);
    Real most = std::min<Real>(samples, largest_pass);
    if (limits.error > 0 && so_far.rmse < inf) {
        const Real wanting = samples * (sqr(so_far.rmse / limits.error) - 1);
        most = std::min(most, std::max(wanting, samples / 8));
    }
    most = std::min(most, limits.time / (passes_in_time * so_far.per_sample));
    const int most_samples = int(std::bit_floor(unsigned(std::max<Real>(most, 1))));
    for (int count = most_samples; count >= std::max(1, most_samples / 4); count /= 2)
        if (so_far.seconds + count * so_far.per_sample <= limits.time) return count;
    return 0;
}

Slice next_slice(Sampler sampler, Bits seed, int pass, std::uint64_t samples, int count) {
    if (sampler == Sampler::stratified || sampler == Sampler::uniform)
        return {sampler, pass == 0 ? seed : combine(seed, Bits(pass)), 0, count};
    // those that must know how many samples there will be
    const bool is_whole = sampler == Sampler::orthogonal || sampler == Sampler::blue_noise;
    const Sampler goes_on = is_whole ? Sampler::sobol : sampler;
    const std::uint64_t sequence = samples / longest_sequence;
    return {goes_on, sequence == 0 ? seed : combine(seed, sequence), int(samples % longest_sequence), count};
}

}  // namespace rt
