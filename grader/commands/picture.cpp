#include "commands/commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>

#include "commands/warp.h"
#include "commands/words.h"
#include "files/files.h"
#include "files/interrupt.h"
#include "judging/breakdown.h"
#include "judging/own_picture.h"
#include "programs/cache.h"
#include "report/picture.h"
#include "report/terminal.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"
#include "studies/numbers.h"

namespace grade {

namespace {

struct PictureArguments {
    std::string scene, submission, with, out;
    std::vector<std::string> mine;
    std::vector<int> size;
    ComparedSettings settings;
    bool trusted = false;
};

constexpr double sqr_of_rounding = 1e-24;  // of linear radiance

bool is_number(rt::Color c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }

/// How two pictures differ, for people.
std::string in_words(const rt::Image& mine, const rt::Image& right) {
    std::size_t count = 0, worst = 0;
    double squares = 0, most = 0;
    const std::size_t width = std::size_t(mine.width);
    if (const auto bad = std::ranges::find_if_not(mine.pixels, is_number); bad != mine.pixels.end()) {
        const std::size_t k = std::size_t(bad - mine.pixels.begin());
        return fmt::format("{} pixels of yours are no number, the first at {},{}",
                           mine.pixels.size() - std::size_t(std::ranges::count_if(mine.pixels, is_number)), k % width,
                           k / width);
    }
    for (std::size_t k = 0; k < mine.pixels.size(); ++k) {
        const rt::Color off = mine.pixels[k] - right.pixels[k];
        if (mine.pixels[k] == right.pixels[k]) continue;
        ++count;
        const double square = rt::dot(off, off) / 3;
        squares += square;
        if (!(square <= most)) most = square, worst = k;
    }
    if (count == 0) return "the same, bit by bit, in this scene: ./grade asks more";
    if (most < sqr_of_rounding) return "the same but for rounding, in this scene: ./grade asks more";
    const auto color = [](rt::Color c) { return fmt::format("({:.4g}, {:.4g}, {:.4g})", c.r, c.g, c.b); };
    return fmt::format("{:.3g} % of the pixels differ, RMSE {:.3g}; most at {},{}: {}, right is {}",
                       100.0 * double(count) / double(mine.pixels.size()),
                       std::sqrt(squares / double(mine.pixels.size())), worst % width, worst / width,
                       color(mine.pixels[worst]), color(right.pixels[worst]));
}

rt::Image minus(const rt::Image& a, const rt::Image& b) {
    rt::Image result = a;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) result.pixels[k] -= b.pixels[k];
    return result;
}

void check_names(const std::vector<std::string>& mine, const Toolchain& chain, const Assignment& assignment) {
    for (const std::string& name : mine)
        if (choose({name}, chain, assignment).fragments.empty())
            throw rt::InputError(fmt::format("--mine {}: no fragment has this name", name));
}

/// Where nothing else lies: .gitignore names the folder. Not beside scenes, where the handout's pictures are.
fs::path default_out(const std::string& scene, const Toolchain& chain) {
    std::error_code error;
    const bool is_beside_scenes = fs::equivalent(fs::current_path(), chain.source / "scenes", error);
    const fs::path folder = is_beside_scenes ? chain.source / "pictures" : fs::path("pictures");
    fs::create_directories(folder);
    return folder / (fs::path(scene).stem().string() + ".png");
}

/// The program with the fragments that are asked for, and what stands in for the others.
fs::path program_of(Programs& programs, const PictureArguments& arguments, const Assignment& assignment) {
    if (!arguments.mine.empty()) {
        const std::set<std::string> mine(arguments.mine.begin(), arguments.mine.end());
        programs.compile(mine);
        for (const std::string& name : mine)
            if (const auto complaint = programs.complaint(name); !complaint.empty())
                throw SubmissionError(fmt::format("{}: {}", name, complaint));
        return programs.must_link(mine);
    }
    const auto names = assignment.names();
    programs.compile({names.begin(), names.end()});
    for (const auto& [name, problem] : programs.problems())
        if (problem.verdict == Verdict::did_not_build)
            fmt::print(stderr, "{}: did not build; its blank stands in\n", name);
    return programs.own_without({});
}

/// In which line a picture broke down.
std::string place_of_fault(const PictureArguments& arguments, const ComparedSettings& settings,
                           const Programs& programs, const Toolchain& chain) {
    std::string place;
    if (arguments.mine.size() == 1)
        place =
            breakdown_of(programs, chain, arguments.mine.front(), render_of(arguments.scene, settings), settings.seed);
    return place.empty() ? "./grade says in which fragment, and in which line" : place;
}

/// Says what is wrong with a scene, before all the work.
void require_scene(const std::string& scene, std::vector<std::string> words, const fs::path& scenes) {
    std::error_code error;
    if (fs::exists(scene, error)) {
        // a device may have no end
        if (!fs::is_regular_file(scene, error))
            throw rt::InputError(scene + ": is no regular file; expected a scene, as scenes/checkerboard.toml");
        rt::read_scene(scene);
        return;
    }
    for (const auto& entry : fs::directory_iterator(scenes, error))
        if (entry.path().extension() == ".toml") words.push_back("scenes/" + entry.path().filename().string());
    std::ranges::sort(words);
    const auto nearest = rt::nearest_word(scene, words);
    throw rt::InputError(fmt::format("{}: no such scene, and no fragment has this name; expected {}", scene,
                                     nearest ? *nearest + "?" : "a file, as scenes/checkerboard.toml"));
}

/// A scene as the submission's fragments draw it, as the solution's do, and the difference; or points of a warp.
/// Returns the exit code: 0; 1 where the submission's program gave no picture, or pixels that are no number.
int run_picture(const PictureArguments& arguments, const Context& context) {
    stop_at_interrupt();
    const Toolchain chain = read_toolchain(context.toolchain);
    const Assignment assignment = assignment_of(chain);
    check_names(arguments.mine, chain, assignment);
    const std::vector<std::string> names = assignment.names();
    const bool is_warp = std::ranges::count(names, arguments.scene) > 0;
    const Rows calls = is_warp ? calls_of_warp(arguments.scene, arguments.with, chain) : Rows();
    if (!is_warp) require_scene(arguments.scene, names, chain.source / "scenes");
    const fs::path out = arguments.out.empty() ? default_out(arguments.scene, chain) : fs::path(arguments.out);
    require_file(out.string(), "--out");
    if (out.extension() != ".png")
        throw rt::InputError(out.string() + ": unknown kind of image; expected --out NAME.png");

    ProgressLine line;
    Progress progress(line.listener());
    const Chosen chosen =
        choose(arguments.submission.empty() ? std::vector<std::string>{} : std::vector{arguments.submission}, chain,
               assignment);
    BuildSettings build;
    build.trusted = arguments.trusted || (chain.is_kit && chosen.own);
    if (const auto cache = cache_folder(chain); cache && chosen.own) build.kept = Kept(*cache / "kept", chain);
    Programs programs(read_submission(chosen.submission, names), chain, build, progress);
    PictureArguments of_one = arguments;
    if (is_warp) of_one.mine = {arguments.scene};
    const fs::path mine = program_of(programs, of_one, assignment);
    progress.tell("drawing both pictures");
    if (is_warp) {
        line.clear();
        return draw_warp(arguments.scene, calls, programs, mine, chain, arguments.settings.time_limit, out);
    }
    ComparedSettings settings = arguments.settings;
    if (!arguments.size.empty()) settings.size = {arguments.size[0], arguments.size[1]};
    const Compared both = draw_compared(programs, mine, arguments.scene, settings);
    line.clear();
    if (!both.right.fault.empty()) throw std::runtime_error("the solution's picture: " + both.right.fault);

    const rt::Image &yours = both.mine.image, &right = both.right.image;
    const std::string stem = fs::path(out).replace_extension().string();
    rt::write_exr(stem + "_right.exr", right);
    if (!both.mine.fault.empty()) {
        rt::write_png(out.string(), right, both.exposure);
        fmt::print("no picture of yours: {}\n{}\n{}: the right one alone\n", both.mine.fault,
                   place_of_fault(arguments, settings, programs, chain), out.string());
        return 1;
    }
    rt::write_exr(stem + "_mine.exr", yours);
    rt::write_exr(stem + "_difference.exr", minus(yours, right));
    const Difference map = difference(yours, right);
    const auto shown = [&](const rt::Image& image) { return scaled(image, both.exposure); };
    rt::write_png(out.string(), side_by_side({shown(yours), shown(right), map.image}));
    fmt::print(
        "{}: yours, the right one, the difference (blue: yours is darker; orange: brighter; full colour at "
        "±{:.2g})\n{}\n",
        out.string(), map.full, in_words(yours, right));
    if (both.mine.seconds > 0 && both.right.seconds > 0)
        fmt::print("CPU time: yours {:.3g} s, the right one {:.3g} s\n", both.mine.seconds, both.right.seconds);
    return std::ranges::all_of(yours.pixels, is_number) ? 0 : 1;
}

}  // namespace

Command picture_command(CLI::App& app) {
    const auto arguments = std::make_shared<PictureArguments>();
    CLI::App* picture =
        app.add_subcommand("picture", "a scene as your fragments draw it, the right one, and the difference");
    picture
        ->add_option("SCENE", arguments->scene,
                     "a scene file (TOML); or a fragment that makes points of random numbers: where they lie")
        ->required();
    picture->add_option("SUBMISSION", arguments->submission, "a folder, a .zip or a .tar.gz; default: starter");
    picture
        ->add_option("--mine", arguments->mine,
                     "only these fragments are yours, the others the solution's; default: all yours, blanks for "
                     "what is missing")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("FRAGMENT");
    picture
        ->add_option("-o,--out", arguments->out,
                     "all three side by side; with NAME_mine.exr, NAME_right.exr and NAME_difference.exr beside it; "
                     "default: the scene's name, in the folder pictures")
        ->type_name("NAME.png");
    picture->add_option("--with", arguments->with, "arguments of that fragment: \"exponent = 20\"")
        ->type_name("ARGUMENTS");
    picture->add_option("--samples", arguments->settings.samples, "samples a pixel; default: the scene's")
        ->check(CLI::Range(1, 1 << 20));
    picture->add_option("--size", arguments->size, "size of the film, WIDTHxHEIGHT; default: the scene's")
        ->delimiter('x')
        ->expected(2)
        ->check(CLI::Range(1, 8192));
    picture->add_option("--seed", arguments->settings.seed, "of both pictures")
        ->capture_default_str()
        ->check(is_seed());
    picture
        ->add_option("--time-limit", arguments->settings.time_limit,
                     "CPU seconds for one picture; default: 5, and of a scene 10 times what the right one takes")
        ->check(in_range(1, 600));
    picture->add_flag("--trusted", arguments->trusted, "the code is your own: limits, but no sandbox");
    return {picture, [arguments](const Context& context) { return run_picture(*arguments, context); }};
}

}  // namespace grade
