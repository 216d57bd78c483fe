/// The command line: raytrace SCENE -o OUT.exr [...]

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>

#include "rt/files/image.h"
#include "rt/files/mitsuba.h"
#include "rt/plan.h"
#include "rt/render.h"
#include "rt/files/scene_reader.h"

namespace {

/// What the program answers the shell.
enum Exit { ok = 0, not_finite = 1, bad_input = 2, no_output = 3 };

struct Options {
    std::string scene, out, mitsuba;
    std::optional<int> samples;
    std::optional<std::string> sampler;
    std::optional<rt::Real> exposure;
    std::vector<int> size, crop, pixel;
    bool plan = false, quiet = false;
    rt::RenderSettings settings;
};

void describe_options(CLI::App& app, Options& o) {
    const std::vector<std::string> names(rt::sampler_names.begin(), rt::sampler_names.end());
    const CLI::Range positive(1e-30, 1e30);
    const auto not_negative = [](const std::string& text) { return text[0] == '-' ? "must not be negative" : ""; };
    app.add_option("scene", o.scene, "a scene file (TOML)")->required();
    app.add_option("-o,--out", o.out, "the image: NAME.exr, with a preview NAME.png beside it");
    app.add_option("--samples", o.samples, "samples a pixel")->check(CLI::Range(1, 1 << 30));
    app.add_option("--sampler", o.sampler, "pattern of the samples")->check(CLI::IsMember(names));
    app.add_option("--seed", o.settings.seed, "another seed, another noise")->check(not_negative);
    app.add_option("--threads", o.settings.threads, "0: one for each core")->check(CLI::Range(0, 1024));
    app.add_option("--size", o.size, "size of the film, WIDTHxHEIGHT")
        ->delimiter('x')->expected(2)->check(CLI::Range(1, 65536));
    app.add_option("--crop", o.crop, "render this part only, X,Y,WIDTH,HEIGHT")->delimiter(',')->expected(4);
    app.add_option("--pixel", o.pixel, "print every intermediate value of this pixel's paths, X,Y")
        ->delimiter(',')->expected(2);
    app.add_option("--time-limit", o.settings.time_limit, "render passes until this time is over [s]")->check(positive);
    app.add_option("--target-error", o.settings.target_error, "render passes until the RMSE is this small")
        ->check(positive);
    app.add_option("--exposure", o.exposure, "factor for the preview")->check(positive);
    app.add_flag("--plan", o.plan, "print what this scene needs and what is left out");
    app.add_option("--export-mitsuba", o.mitsuba, "write the scene for Mitsuba 3: NAME.xml, with its meshes beside it");
    app.add_flag("--quiet", o.quiet, "print nothing but errors");
}

/// A mistake on the command line.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The scene, with the options that take the place of its settings.
rt::Scene read_scene(const Options& o) {
    rt::Scene scene = rt::read_scene(o.scene);
    if (o.samples) scene.samples = *o.samples;
    if (o.sampler) scene.sampler = *rt::sampler_named(*o.sampler);
    if (o.exposure) scene.exposure = *o.exposure;
    if (!o.size.empty()) scene.camera.size = {o.size[0], o.size[1]};
    if (std::int64_t(scene.camera.size.x) * scene.camera.size.y > (1 << 28))
        throw UsageError("--size: too large; expected at most 268435456 pixels");
    return scene;
}

void check_inside(const std::vector<int>& part, rt::ivec2 size, const char* option) {
    const bool box = part.size() == 4;
    const std::int64_t x = part[0], y = part[1], width = box ? part[2] : 1, height = box ? part[3] : 1;
    if (x < 0 || y < 0 || width < 1 || height < 1 || x + width > size.x || y + height > size.y)
        throw UsageError(fmt::format("--{}: {} is not within the image; expected a part of 0,0 to {},{}", option,
                                     fmt::join(part, ","), size.x - 1, size.y - 1));
}

rt::RenderSettings make_settings(const Options& o, const rt::Scene& scene) {
    rt::RenderSettings settings = o.settings;
    settings.samples = scene.samples;
    settings.sampler = scene.sampler;
    if (!o.crop.empty()) {
        check_inside(o.crop, scene.camera.size, "crop");
        settings.crop = rt::Crop{o.crop[0], o.crop[1], o.crop[2], o.crop[3]};
    }
    return settings;
}

/// Before the rendering: it would be a pity to find out afterwards.
void check_output(const std::string& out) {
    const std::filesystem::path path(out);
    if (out.empty())
        throw UsageError("no output; expected -o NAME.exr, --plan, --pixel X,Y or --export-mitsuba NAME.xml");
    if (path.extension() != ".exr") throw UsageError(out + ": unknown kind of image; expected -o NAME.exr");
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (access(folder.c_str(), W_OK) != 0)
        throw std::runtime_error(
            fmt::format("{}: cannot be written: {}: {}", out, folder.string(), std::strerror(errno)));
}

std::atomic<bool> interrupted = false;

/// A bar with the time left, ten times a second at most.
void show_progress(rt::Real done, rt::Real seconds_left) {
    using Clock = std::chrono::steady_clock;
    static Clock::time_point last{};
    if (Clock::now() - last < std::chrono::milliseconds(100)) return;
    last = Clock::now();
    const int width = 40, full = int(done * width);
    const auto bar = std::string(std::size_t(full), '#') + std::string(std::size_t(width - full), '.');
    const auto left = seconds_left < 1e6 ? fmt::format("{:.0f} s left", seconds_left) : std::string();
    fmt::print(stderr, "\r[{}] {:3.0f} % {}{}\033[K", bar, 100 * done, left, interrupted ? ", stopping" : "");
    std::fflush(stderr);
}

std::string in_words(std::uint64_t n) {
    if (n < 100000) return fmt::format("{}", n);
    return n < 100000000 ? fmt::format("{:.3g} M", 1e-6 * double(n)) : fmt::format("{:.4g} M", 1e-6 * double(n));
}

void report(const std::string& out, const rt::Rendering& r) {
    fmt::print("{}: {} x {} pixels, {} samples a pixel\n", out, r.image.width, r.image.height, r.samples);
    fmt::print("error    {:.3g} estimated RMSE\n", r.rmse);
    fmt::print("time     {:.4f} s CPU, {:.4f} s wall\n", r.cpu_seconds, r.wall_seconds);
    fmt::print("rays    ");
    const char* comma = " ";
    for (std::size_t i = 0; i < r.rays.size(); ++i) {
        if (r.rays[i] > 0) fmt::print("{}{} {}", comma, in_words(r.rays[i]), rt::ray_kind_names[i]);
        if (r.rays[i] > 0) comma = ", ";
    }
    const auto samples = double(r.rays[std::size_t(rt::RayKind::camera)]);
    fmt::print("\nspeed    {:.3g} M samples per CPU second\n", 1e-6 * samples / std::max(r.cpu_seconds, 1e-9));
}

/// The command which shows how a number that is none came about; the fault begins with "pixel X,Y".
void report_fault(const Options& o, const rt::RenderSettings& settings, const rt::Scene& scene,
                  const std::string& fault) {
    int x = 0, y = 0;
    std::sscanf(fault.c_str(), "pixel %d,%d", &x, &y);
    fmt::print(stderr,
               "{}: {}; expected a finite number\n"
               "To see how it came about: raytrace {} --pixel {},{} --seed {} --samples {} --sampler {} --size {}x{}{}\n",
               o.scene, fault, o.scene, x, y, settings.seed, settings.samples, rt::sampler_names[std::size_t(settings.sampler)], scene.camera.size.x,
               scene.camera.size.y, rt::sampling_of(settings).passes ? " --time-limit 1" : "");
}

int run(const Options& o) {
    const rt::Scene scene = read_scene(o);
    rt::RenderSettings settings = make_settings(o, scene);
    if (o.plan) fmt::print("{}", rt::describe(rt::make_plan(scene, rt::sampling_of(settings)), scene));
    if (!o.pixel.empty()) {
        check_inside(o.pixel, scene.camera.size, "pixel");
        fmt::print("{}", rt::trace_pixel(scene, settings, o.pixel[0], o.pixel[1]));
    }
    if (!o.mitsuba.empty()) rt::export_mitsuba(scene, o.mitsuba);
    if (o.out.empty() && (o.plan || !o.pixel.empty() || !o.mitsuba.empty())) return ok;
    check_output(o.out);

    const bool bar = !o.quiet && isatty(STDERR_FILENO);
    if (bar) settings.progress = show_progress;
    // The first Ctrl-C ends soon and writes what is there, the second ends at once.
    settings.stop = [] { return interrupted.load(); };
    struct sigaction action {};
    action.sa_handler = [](int) { interrupted = true; };
    action.sa_flags = int(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);

    const rt::Rendering rendering = rt::render(scene, settings);
    if (bar) fmt::print(stderr, "\r\033[K");
    rt::write_exr(o.out, rendering.image);
    rt::write_png(std::filesystem::path(o.out).replace_extension(".png").string(), rendering.image, scene.exposure);
    if (rendering.done < 1)
        fmt::print(stderr, "{}: {} after {:.3g} % of the picture; what is missing is black\n", o.out,
                   interrupted ? "interrupted" : "the time was over", 100 * rendering.done);
    if (!o.quiet) report(o.out, rendering);
    if (rendering.fault.empty()) return ok;
    report_fault(o, settings, scene, rendering.fault);
    return not_finite;
}

}  // namespace

int main(int count, char** words) {
    CLI::App app("Renders a scene.");
    Options options;
    describe_options(app, options);
    try {
        app.parse(count, words);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? ok : bad_input;
    }
    try {
        return run(options);
    } catch (const rt::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return bad_input;
    } catch (const UsageError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return bad_input;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "{}: not enough memory; expected a smaller image or scene\n", options.scene);
        return no_output;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return no_output;
    }
}
