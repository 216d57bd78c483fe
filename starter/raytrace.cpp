/// The command line: raytrace SCENE -o OUT.exr [...]

#include <fmt/format.h>
#include <unistd.h>
#include <CLI/CLI.hpp>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>

#include "rt/files/image.h"
#include "rt/files/mitsuba.h"
#include "rt/files/scene_reader.h"
#include "rt/plan.h"
#include "rt/processor.h"
#include "rt/render.h"
#include "rt/show/bar.h"
#include "rt/show/onlookers.h"
#include "rt/show/report.h"

namespace {

/// What the program answers the shell.
enum Exit { ok = 0, not_finite = 1, bad_input = 2, no_output = 3 };

struct Options {
    std::string scene, out, mitsuba, preview, tev;
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
        ->delimiter('x')
        ->expected(2)
        ->check(CLI::Range(1, 65536));
    app.add_option("--crop", o.crop, "render this part only, X,Y,WIDTH,HEIGHT")->delimiter(',')->expected(4);
    app.add_option("--pixel", o.pixel, "print what each fragment answers along this pixel's paths, X,Y")
        ->delimiter(',')
        ->expected(2);
    app.add_option("--time-limit", o.settings.time_limit,
                   "render pass after pass, whatever --samples says, until this time is over [s]")
        ->check(positive);
    app.add_option("--target-error", o.settings.target_error, "render pass after pass until the RMSE is this small")
        ->check(positive);
    app.add_option("--exposure", o.exposure, "factor for the preview")->check(positive);
    app.add_flag("--preview{auto}", o.preview,
                 "draw the picture into the terminal while it is made; =blocks, =kitty or =sixel: so")
        ->check(CLI::IsMember({"auto", "blocks", "kitty", "sixel"}));
    app.add_option("--tev", o.tev, "show the picture in the viewer tev while it is made, HOST:PORT");
    app.add_flag("--plan", o.plan, "print what this scene needs and what is left out");
    app.add_option("--export-mitsuba", o.mitsuba, "write the scene for Mitsuba 3: NAME.xml, with its meshes beside it");
    app.add_flag("--quiet", o.quiet, "print nothing but errors");
}

/// The scene, with the options that take the place of its settings.
rt::Scene read_scene(const Options& o) {
    rt::Scene scene = rt::read_scene(o.scene);
    if (o.samples) scene.samples = *o.samples;
    if (o.sampler) scene.sampler = *rt::sampler_named(*o.sampler);
    if (o.exposure) scene.exposure = *o.exposure;
    if (!o.size.empty()) scene.camera.size = {o.size[0], o.size[1]};
    if (std::int64_t(scene.camera.size.x) * scene.camera.size.y > (1 << 28))
        throw rt::InputError("--size: too large; expected at most 268435456 pixels");
    return scene;
}

void check_inside(const std::vector<int>& part, rt::ivec2 size, const char* option) {
    const bool box = part.size() == 4;
    const std::int64_t x = part[0], y = part[1], width = box ? part[2] : 1, height = box ? part[3] : 1;
    if (x < 0 || y < 0 || width < 1 || height < 1 || x + width > size.x || y + height > size.y)
        throw rt::InputError(fmt::format("--{}: {} is not within the image; expected a part of 0,0 to {},{}", option,
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
        throw rt::InputError(
            "no output; expected -o NAME.exr, --preview, --tev HOST:PORT, --plan, --pixel X,Y or --export-mitsuba "
            "NAME.xml");
    if (path.extension() != ".exr") throw rt::InputError(out + ": unknown kind of image; expected -o NAME.exr");
    const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    if (access(folder.c_str(), W_OK) != 0)
        throw std::runtime_error(
            fmt::format("{}: cannot be written: {}: {}", out, folder.string(), std::strerror(errno)));
}

std::atomic<bool> interrupted = false;

/// The first Ctrl-C ends soon and writes what is there, the second ends at once.
void listen_for_interrupts() {
    struct sigaction action {};
    action.sa_handler = [](int) { interrupted = true; };
    action.sa_flags = int(SA_RESETHAND);
    sigaction(SIGINT, &action, nullptr);
}

rt::ShowOptions make_show_options(const Options& o, const rt::Scene& scene, const rt::RenderSettings& settings) {
    rt::ShowOptions show{o.preview, scene.exposure, {}, o.out.empty() ? o.scene : o.out, scene.camera.size};
    if (settings.crop) show.corner = {settings.crop->x, settings.crop->y};
    if (o.tev.empty()) return show;
    show.tev = rt::tev_address(o.tev);
    if (!show.tev)
        throw rt::InputError("--tev: " + o.tev + " is no address; expected HOST:PORT, such as localhost:14158");
    return show;
}

int render(const Options& o, const rt::Scene& scene, rt::RenderSettings settings) {
    const rt::ShowOptions show = make_show_options(o, scene, settings);
    listen_for_interrupts();
    rt::Onlookers onlookers(show);
    const bool bar = !o.quiet && isatty(STDERR_FILENO);
    if (bar) settings.progress = [](rt::Real done, rt::Real left) { rt::show_bar(done, left, interrupted); };
    if (onlookers.any()) settings.show = [&](const rt::Image& image) { onlookers.show(image); };
    settings.stop = [] { return interrupted.load(); };

    const rt::Rendering rendering = rt::render(scene, settings);
    if (bar) rt::clear_bar();
    onlookers.finish(rendering.image);
    if (!o.out.empty()) {
        rt::write_exr(o.out, rendering.image, rt::label_of(o.scene, scene.camera.size, settings, rendering));
        rt::write_png(std::filesystem::path(o.out).replace_extension(".png").string(), rendering.image, scene.exposure);
    }
    if (!o.out.empty()) fmt::print(stderr, "{}", rt::report_range(o.out, rendering.image));
    if (rendering.done < 1)
        fmt::print(stderr, "{}: {} after {:.3g} % of the picture; what is missing is black\n", show.name,
                   interrupted ? "interrupted" : "the time was over", 100 * rendering.done);
    if (!o.quiet) fmt::print("{}", rt::report(show.name, settings, rendering));
    if (!rendering.bad_sample) return ok;
    fmt::print(stderr, "{}", rt::report_bad_sample(o.scene, scene.camera.size, settings, *rendering.bad_sample));
    return not_finite;
}

int run(const Options& o) {
    const rt::Scene scene = read_scene(o);
    const rt::RenderSettings settings = make_settings(o, scene);
    if (o.plan) fmt::print("{}", rt::describe(rt::make_plan(scene, rt::sampling_of(settings)), scene));
    if (!o.pixel.empty()) {
        check_inside(o.pixel, scene.camera.size, "pixel");
        fmt::print("{}", rt::trace_pixel(scene, settings, o.pixel[0], o.pixel[1]));
    }
    if (!o.mitsuba.empty()) rt::export_mitsuba(scene, o.mitsuba);
    const bool shows = !o.preview.empty() || !o.tev.empty();
    if (o.out.empty() && !shows && (o.plan || !o.pixel.empty() || !o.mitsuba.empty())) return ok;
    if (!o.out.empty() || !shows) check_output(o.out);
    return render(o, scene, settings);
}

}  // namespace

int main(int count, char** words) {
    rt::require_processor();
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
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "{}: not enough memory; expected a smaller image or scene\n", options.scene);
        return no_output;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return no_output;
    }
}
