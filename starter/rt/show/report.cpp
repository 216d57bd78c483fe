#include "rt/show/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <climits>

namespace rt {
namespace {

std::string in_words(std::uint64_t n) {
    if (n < 100000) return fmt::format("{}", n);
    return n < 100000000 ? fmt::format("{:.3g} M", 1e-6 * double(n)) : fmt::format("{:.4g} M", 1e-6 * double(n));
}

std::string name_of(Sampler sampler) { return std::string(sampler_names[std::size_t(sampler)]); }

/// The pattern that the samples really had.
Sampler sampler_used(const RenderSettings& s) {
    return sampling_of(s).passes ? next_slice(s.sampler, s.seed, 0, 0, 1).sampler : pattern_of(s.sampler, s.samples);
}

}  // namespace

std::string report(const std::string& name, const RenderSettings& settings, const Rendering& r) {
    std::string text = fmt::format("{}: {} x {} pixels, {} {} a pixel\n", name, r.image.width, r.image.height,
                                   r.samples, r.samples == 1 ? "sample" : "samples");
    const bool known = !std::isnan(r.rmse);
    text += known ? fmt::format("error    {:.3g} estimated RMSE\n", r.rmse) : "error    unknown\n";
    text += fmt::format("time     {:.4f} s CPU, {:.4f} s wall\n", r.cpu_seconds, r.wall_seconds);
    text += "rays    ";
    const char* comma = " ";
    for (std::size_t i = 0; i < r.rays.size(); ++i) {
        if (r.rays[i] > 0) text += fmt::format("{}{} {}", comma, in_words(r.rays[i]), ray_kind_names[i]);
        if (r.rays[i] > 0) comma = ", ";
    }
    if (known) text += fmt::format("; {} pixels are rendered twice, to estimate the error", r.twice);
    const auto samples = double(r.rays[std::size_t(RayKind::camera)]);
    text += fmt::format("\nspeed    {:.3g} M samples per CPU second\n", 1e-6 * samples / std::max(r.cpu_seconds, 1e-9));
    text += fmt::format("hash     {:016x}\n", hash_of(r.image));
    const bool early = settings.time_limit < inf && r.wall_seconds < 0.9 * settings.time_limit;
    if (early && !(r.rmse <= settings.target_error) && !r.stopped)
        text += fmt::format("limit    another sample of every pixel does not fit into {:g} s\n", settings.time_limit);
    return text;
}

Label label_of(const std::string& scene, ivec2 film, const RenderSettings& settings, const Rendering& r) {
    Label label;
    label.film = film;
    if (settings.crop) label.corner = {settings.crop->x, settings.crop->y};
    label.attributes = {{"renderer", fmt::format("Penumbra {}", version)},
                        {"scene", scene},
                        {"samples", int(std::min<std::uint64_t>(r.samples, INT_MAX))},
                        {"seed", fmt::format("{}", settings.seed)},
                        {"sampler", name_of(sampler_used(settings))},
                        {"cpu_seconds", r.cpu_seconds},
                        {"wall_seconds", r.wall_seconds}};
    if (!std::isnan(r.rmse)) label.attributes.emplace_back("error", r.rmse);
    if (r.done < 1) label.attributes.emplace_back("done", r.done);
    return label;
}

std::string report_range(const std::string& name, const Image& image) {
    std::size_t bright = 0, dark = 0;
    for (const Color& c : image.pixels) {
        bright += std::isfinite(largest(c)) && largest(c) > Real(std::numeric_limits<float>::max());
        dark += largest(c) > 0 && float(largest(c)) == 0;
    }
    std::string text;
    if (bright > 0)
        text += fmt::format(
            "{}: {} pixels are brighter than the {:.2g} that a file holds, and are written as that; expected dimmer "
            "lights\n",
            name, bright, std::numeric_limits<float>::max());
    if (dark > 0)
        text += fmt::format(
            "{}: {} pixels are darker than the {:.2g} that a file holds, and are written as 0; expected brighter "
            "lights\n",
            name, dark, std::numeric_limits<float>::denorm_min());
    return text;
}

std::string report_bad_sample(const std::string& scene, ivec2 film, const RenderSettings& settings,
                              const BadSample& bad) {
    const int x = bad.pixel.x, y = bad.pixel.y;
    const Color c = bad.radiance;
    const std::string what = bad.sample ? fmt::format(", sample {}: radiance {} {} {}", *bad.sample, c.x, c.y, c.z)
                                        : ": the mean is no finite number, though every sample is";
    return fmt::format(
        "{}: pixel {},{}{}; expected a finite number\n"
        "To see how it came about: raytrace {} --pixel {},{} --seed {} --samples {} --sampler {} --size {}x{}{}\n",
        scene, x, y, what, scene, x, y, bad.slice.seed, bad.slice.first + bad.slice.count, name_of(bad.slice.sampler),
        film.x, film.y, sampling_of(settings).passes ? " --time-limit 1" : "");
}

}  // namespace rt
