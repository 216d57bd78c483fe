#include "judging/own_picture.h"

#include "build/runner.h"
#include "judging/parallel.h"
#include "rt/files/scene_reader.h"

namespace grade {

Compared draw_compared(Programs& programs, const fs::path& mine, const fs::path& scene,
                       const ComparedSettings& settings) {
    const std::string text = read_text(scene, std::uint64_t(1) << 30).value_or("");
    const rt::Scene parsed = rt::parse_scene(text, scene.string());
    const Render experiment{text, settings.samples > 0 ? settings.samples : parsed.samples,
                            std::string(rt::sampler_names[std::size_t(parsed.sampler)]), settings.size};
    const fs::path meshes = fs::absolute(scene).parent_path(), right = programs.with({}).program;
    Compared result;
    result.exposure = parsed.exposure;
    in_parallel(2, 2, [&](int i) {
        Runner runner(programs.copy_for(i == 0 ? "mine" : "right", i == 0 ? mine : right), programs.sandbox(), meshes,
                      settings.time_limit);
        auto outcome = runner.render(experiment, settings.seed);
        (i == 0 ? result.mine_seconds : result.right_seconds) = runner.seconds();
        if (const Fault* fault = std::get_if<Fault>(&outcome))
            (i == 0 ? result.mine_fault : result.right_fault) = fault->message;
        else (i == 0 ? result.mine : result.right) = std::move(std::get<rt::Image>(outcome));
    });
    return result;
}

void add_own_picture(Record& record, Programs& programs, const fs::path& scene, std::uint64_t seed, double time_limit) {
    constexpr int samples = 16, longest_side = 240;
    for (const FragmentRecord& fragment : record.fragments)
        if (fragment.verdict == Verdict::crashed || fragment.verdict == Verdict::timed_out)
            record.left_out.push_back(fragment.name);

    rt::ivec2 size = rt::read_scene(scene.string()).camera.size;
    if (const int side = std::max(size.x, size.y); side > longest_side)
        size = {std::max(1, size.x * longest_side / side), std::max(1, size.y * longest_side / side)};
    const fs::path mine = programs.own_without({record.left_out.begin(), record.left_out.end()});
    Compared compared = draw_compared(programs, mine, scene, {samples, size, seed, 3 * time_limit});
    record.own_picture_scene = scene.filename().string();
    record.own_picture_exposure = compared.exposure;
    record.own_picture_fault = compared.mine_fault;
    record.own_picture = std::move(compared.mine);
    record.own_picture_right = std::move(compared.right);
}

}  // namespace grade
