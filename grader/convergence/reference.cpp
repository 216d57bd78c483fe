#include "convergence/reference.h"

#include <fmt/format.h>

#include <algorithm>

#include "files/stamp.h"
#include "programs/kept_file.h"
#include "rt/files/scene_reader.h"
#include "statistics/image_fault.h"

namespace grade::convergence {

namespace {

constexpr double time_limit = 600;  // CPU seconds of one half

struct KeptReference {
    int samples = 0;  // of each half
    Halves halves;
};

KeptReference reference_from(const KeptJson& kept) {
    const KeptJson& halves = kept.at("halves");
    return {kept.at("samples"), {image_of(halves.at(0)), image_of(halves.at(1))}};
}

}  // namespace

rt::ivec2 size_of(const rt::Scene& scene, int side) {
    const rt::ivec2 size = scene.camera.size;
    const int longer = std::max(size.x, size.y);
    if (side <= 0 || longer <= side) return size;
    return {std::max(1, size.x * side / longer), std::max(1, size.y * side / longer)};
}

std::uint64_t seed_of(int samples, int replicate) {
    return (std::uint64_t(samples) << 20) + std::uint64_t(replicate) + 1;
}

Outcome<rt::Image> picture(Runner& runner, const Render& render, std::uint64_t seed) {
    auto outcome = runner.render(render, seed);
    if (const auto* image = std::get_if<rt::Image>(&outcome))
        if (const auto fault = image_fault(*image, render.size.x, render.size.y))
            return Fault{fault->verdict, fault->words, {}};
    return outcome;
}

int last_level(const Amounts& amounts, double budget, double seconds, int series) {
    int last = amounts.samples.front();
    double spent = 0;
    for (const int samples : amounts.samples) {
        const double of_one = seconds * samples * series;  // of one replicate of all
        if (spent + of_one * std::min(least_replicates, amounts.replicates) > budget) break;
        last = samples;
        spent += of_one * amounts.replicates;
    }
    return last;
}

Halves reference_of(const fs::path& file, const Bench& bench, const Amounts& amounts, double budget,
                    SceneRecord& record) {
    const rt::ivec2 size = size_of(rt::read_scene(file.string()), amounts.side);
    const std::string text = read_text(file).value_or("");
    const std::string name = file.stem().string();
    const std::string stamp = Stamp().add(text + fmt::format("{}x{}", size.x, size.y)).add(bench.solution_stamp).text();
    const fs::path path = bench.results / fmt::format("{}-{}", name, stamp) / "reference";
    Runner runner(bench.copy(bench.solution), bench.sandbox, fs::absolute(file).parent_path(), time_limit);
    // level 0: seeds that no level has
    const auto made = [&](int samples, int which) {
        auto outcome = picture(runner, {text, samples, "sobol", size}, seed_of(0, which));
        if (const Fault* fault = std::get_if<Fault>(&outcome))
            throw std::runtime_error(fmt::format("{}: the solution itself: reference of {} samples: {}", file.string(),
                                                 samples, fault->message));
        return std::move(std::get<rt::Image>(outcome));
    };

    // a first picture is slower than the others
    constexpr int few = 16;
    for (const int samples : {1, few}) made(samples, 2);
    const int programs = bench.submission.empty() ? 1 : 2;
    const int wanted = 4 * last_level(amounts, budget, runner.seconds() / few, programs * int(amounts.samplers.size()));

    // half as many will do: what can be foreseen of the last level depends on how busy the machine is
    std::optional<KeptReference> kept = read_kept(path, reference_from);
    if (!kept || 2 * kept->samples < wanted) {
        const auto half = [&](int which) {
            if (bench.progress) bench.progress(0, fmt::format("{}: reference, half {}", name, which + 1));
            return made(wanted, which);
        };
        kept = KeptReference{wanted, {half(0), half(1)}};
        write_kept(
            path, {{"samples", wanted}, {"halves", {kept_image(kept->halves.first), kept_image(kept->halves.second)}}});
    }
    record.reference_samples = kept->samples;
    record.reference_noise = noise_of(kept->halves);
    return std::move(kept->halves);
}

}  // namespace grade::convergence
