#include "convergence/reference.h"

#include <fmt/format.h>

#include <algorithm>

#include "build/stamp.h"
#include "convergence/keep.h"
#include "rt/scene_reader.h"
#include "statistics/image_fault.h"

namespace grade {

namespace {

constexpr double time_limit = 600;  // CPU seconds of one half

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
            return Fault{Verdict::not_an_image, *fault, {}};
    return outcome;
}

std::optional<Halves> reference_of(const fs::path& file, const Bench& bench, const Amounts& amounts,
                                   SceneRecord& record) {
    const rt::ivec2 size = size_of(rt::read_scene(file.string()), amounts.side);
    const std::string text = read_text(file).value_or("");
    record.own_reference = bench.solution.empty();
    record.reference_samples = 2 * amounts.samples.back();
    const std::string& by = record.own_reference ? bench.submission_stamp : bench.solution_stamp;
    const std::string name =
        Stamp().add(text + fmt::format("{}x{} {}", size.x, size.y, record.reference_samples)).add(by).text();
    const fs::path path = bench.results / fmt::format("{}-{}", file.stem().string(), name) / "reference";
    std::optional<Kept> kept = read_kept(path);
    if (!kept || kept->images.size() != 2) {
        kept.emplace();
        Runner runner(bench.copy(record.own_reference ? bench.submission : bench.solution), bench.sandbox,
                      fs::absolute(file).parent_path(), time_limit);
        for (int half = 0; half < 2; ++half) {
            if (bench.progress)
                bench.progress(0, fmt::format("{}: reference, half {}", file.stem().string(), half + 1));
            // as a replicate that no level has
            auto outcome = picture(runner, {text, record.reference_samples, "sobol", size}, seed_of(0, half));
            if (const Fault* fault = std::get_if<Fault>(&outcome)) {
                record.fault = fmt::format("reference of {} samples: {}", record.reference_samples, fault->message);
                if (record.own_reference) return std::nullopt;
                throw std::runtime_error(fmt::format("{}: the solution itself: {}", file.string(), record.fault));
            }
            kept->images.push_back(std::move(std::get<rt::Image>(outcome)));
        }
        write_kept(path, *kept);
    }
    Halves halves{std::move(kept->images[0]), std::move(kept->images[1])};
    record.reference_noise = noise_of(halves);
    return halves;
}

}  // namespace grade
