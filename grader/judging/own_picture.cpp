#include "judging/own_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "programs/parallel.h"
#include "programs/runner.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

/// What a picture of mine may take: many times what one sample a pixel of the right one says that this takes. A
/// fragment that is right and slow is far from it.
double limit_of(Programs& programs, const fs::path& meshes, Render picture, std::uint64_t seed) {
    constexpr double some = 5, times = 10, most = 600;  // CPU seconds
    const int samples = std::exchange(picture.samples, 1);
    Runner runner(programs.copy_for("first", programs.with({}).program), programs.sandbox(), meshes, most);
    const auto outcome = runner.render(picture, seed, false);
    if (std::holds_alternative<Fault>(outcome)) return most;
    return std::min(std::ceil(some + times * samples * runner.seconds()), most);
}

}  // namespace

Render render_of(const fs::path& scene, const ComparedSettings& settings) {
    const std::string text = read_text(scene, std::uint64_t(1) << 30).value_or("");
    const rt::Scene parsed = rt::parse_scene(text, scene.string());
    return {text, settings.samples > 0 ? settings.samples : parsed.samples,
            std::string(rt::sampler_names[std::size_t(parsed.sampler)]), settings.size};
}

Compared draw_compared(Programs& programs, const fs::path& mine, const fs::path& scene,
                       const ComparedSettings& settings) {
    const Render experiment = render_of(scene, settings);
    const fs::path meshes = fs::absolute(scene).parent_path();
    const double limit =
        settings.time_limit > 0 ? settings.time_limit : limit_of(programs, meshes, experiment, settings.seed);
    const std::string from =
        fmt::format("{} {} {} {}x{} {} {}\n{}", meshes.string(), settings.seed, experiment.samples, settings.size.x,
                    settings.size.y, experiment.sampler, settings.time_limit, experiment.scene);
    const Kept& kept = programs.kept();
    Compared result;
    result.exposure = rt::parse_scene(experiment.scene, scene.string()).exposure;
    const auto draw = [&](const std::string& name, const std::string& made_from, const auto& program) {
        if (auto before = kept.drawn(name, made_from)) return std::move(*before);
        Runner runner(programs.copy_for(name, program()), programs.sandbox(), meshes, limit);
        auto outcome = runner.render(experiment, settings.seed, false);
        Drawn drawn{{}, "", runner.seconds()};
        if (const Fault* bad = std::get_if<Fault>(&outcome)) {
            drawn.fault = bad->message;
            if (bad->trouble != Trouble::endless) return drawn;  // it is soon there again, and may be the machine's
        } else {
            drawn.image = std::move(std::get<rt::Image>(outcome));
        }
        kept.keep_drawn(name, made_from, drawn);
        return drawn;
    };
    in_parallel(2, 2, [&](int i) {
        if (i == 0)
            result.mine = draw("own_picture", from + read_text(mine).value_or(""), [&] { return mine; });
        else
            result.right = draw("right_picture", from, [&] { return programs.with({}).program; });
    });
    return result;
}

namespace {

/// The submission's own program; where some fragments alone are graded, these with the right others, or nothing where
/// none of them can be part of it.
fs::path program_of(Record& record, Programs& programs) {
    record.own_picture_of_some = record.fragments.size() < programs.names().size();
    if (!record.own_picture_of_some) {
        programs.compile(programs.names());
        return programs.own_without({record.left_out.begin(), record.left_out.end()});
    }
    std::set<std::string> graded;
    for (const FragmentRecord& fragment : record.fragments)
        if (programs.has(fragment.name)) graded.insert(fragment.name);
    for (const std::string& name : record.left_out) graded.erase(name);
    return graded.empty() ? fs::path() : programs.must_link(graded);
}

}  // namespace

void add_own_picture(Record& record, Programs& programs, const fs::path& scene, std::uint64_t seed, double time_limit) {
    constexpr int samples = 16, longest_side = 240;
    for (const FragmentRecord& fragment : record.fragments)
        if (fragment.verdict == Verdict::crashed || fragment.verdict == Verdict::timed_out)
            record.left_out.push_back(fragment.name);

    rt::ivec2 size = rt::read_scene(scene.string()).camera.size;
    if (const int side = std::max(size.x, size.y); side > longest_side)
        size = {std::max(1, size.x * longest_side / side), std::max(1, size.y * longest_side / side)};
    const fs::path mine = program_of(record, programs);
    if (mine.empty()) return;
    Compared compared = draw_compared(programs, mine, scene, {samples, size, seed, 3 * time_limit});
    record.own_picture_scene = scene.filename().string();
    record.own_picture_exposure = compared.exposure;
    record.own_picture_fault = compared.mine.fault;
    record.own_picture = std::move(compared.mine.image);
    record.own_picture_right = std::move(compared.right.image);
}

}  // namespace grade
