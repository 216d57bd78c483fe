#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/fragment_checks.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
#include "rt/files/scene_reader.h"
#include "statistics/irradiance.h"

namespace grade {

namespace {

using rt::Event, rt::vec3;

Check truth_table() {
    const auto inputs = [](Generator&) {
        Rows rows;
        for (const Event event : {Event::camera, Event::diffuse, Event::specular, Event::lobe, Event::medium})
            for (const bool sampled : {false, true}) rows.push_back(row(event, sampled));
        return rows;
    };
    const auto table = [](auto counts) {
        return of<Event, bool>([=](Event event, bool sampled) { return counts(event, sampled); });
    };
    Statistic right = formula(
        "F1", "wrong answers", table([](Event e, bool sampled) { return e != Event::diffuse || !sampled; }), 0,
        {{"every emitter counts: a diffuse ray gathers again what shadow rays have gathered",
          table([](Event, bool) { return true; })},
         {"no emitter counts", table([](Event, bool) { return false; })},
         {"the answer is the wrong way round",
          table([](Event e, bool sampled) { return e == Event::diffuse && sampled; })},
         {"emitters are seen by the camera alone", table([](Event e, bool) { return e == Event::camera; })},
         {"no emitter counts after a diffuse bounce: one that no shadow ray looks for must",
          table([](Event e, bool) { return e != Event::diffuse; })},
         {"a sampled emitter never counts: the camera, mirrors, glass, lobes and media send no shadow rays",
          table([](Event, bool sampled) { return !sampled; })},
         {"whether shadow rays look for the emitter is taken the wrong way round",
          table([](Event e, bool sampled) { return e != Event::diffuse || sampled; })},
         {"a sampled emitter counts from the camera alone: mirrors, glass, lobes and media send no shadow rays either",
          table([](Event e, bool sampled) { return e == Event::camera || !sampled; })},
         {"a sampled emitter does not count after glass or a mirror: caustics are missing",
          table([](Event e, bool sampled) {
              return !sampled || e == Event::camera || e == Event::lobe || e == Event::medium;
          })},
         {"a sampled emitter does not count after a glossy lobe, which sends no shadow rays",
          table([](Event e, bool sampled) {
              return !sampled || e == Event::camera || e == Event::specular || e == Event::medium;
          })},
         {"a sampled emitter does not count inside a medium, which sends no shadow rays",
          table([](Event e, bool sampled) { return !sampled || (e != Event::diffuse && e != Event::medium); })}});
    right.hint = [](double, double) { return std::string("the answer is wrong for some kind of path"); };
    return probe_check("truth_table", inputs, {right});
}

/// A floor under a lamp, perhaps with a pane of glass in between that does not bend light. However the floor's light is
/// gathered, by shadow rays or by diffuse rays that hit the lamp, it is
///
///     albedo/pi L quad_irradiance
Check floor_under_lamp(Generator& random, const std::string& name, bool sampled, bool pane, Hint hint) {
    const Place place = any_place(random);
    const rt::Quad lamp{place({between(random, -0.3, 0.3), between(random, -0.3, 0.3), 1}),
                        between(random, 0.6, 0.9) * place.axes.x, -between(random, 0.6, 0.9) * place.axes.y};
    const View view{place({2.5, 0, 0.8}), place({0, 0, 0}), place.turned({0, 0, 1}), 12, {24, 24}};
    const double radiance = between(random, 1, 4), albedo = between(random, 0.5, 0.9);
    std::string scene = fmt::format(
                            "[render]\nbounces = 2\n\n{}[materials.floor]\nalbedo = {}\n\n[materials.lamp]\nemission = "
                            "{}\nsampled = {}\n\n",
                            toml(view), toml(albedo), toml(radiance), sampled) +
                        quad("floor", place({0, 0, 0}), 3.0 * place.axes.x, 3.0 * place.axes.y) +
                        quad("lamp", lamp.center, lamp.u, lamp.v);
    if (pane)
        scene += "[materials.pane]\ntransmittance = 1\n\n" +
                 quad("pane", place({0, 0, 0.6}), 1.5 * place.axes.x, 1.5 * place.axes.y);

    const rt::Camera camera = rt::parse_scene(scene, "floor").camera;
    double due = 0;
    for (int y = 0; y < view.size.y; ++y)
        for (int x = 0; x < view.size.x; ++x) {
            const double sight = over_pixel(x, y, [&](rt::vec2 film) {
                return quad_irradiance(lamp, seen_on_plane(camera, film, place.origin, place.axes.z), place.axes.z);
            });
            due += albedo / rt::pi * radiance * sight / (view.size.x * view.size.y);
        }
    Statistic light = of_picture("F1", "light of the floor, over what must be",
        [=](const rt::Image& image) { return region_mean(image, whole(image)).r / due; }, 1, 0.05, std::move(hint));
    return render_check(name, {scene, 32, "sobol"}, {light});
}

}  // namespace

Checks check_emission_counts(Generator& random) {
    return {truth_table(),
            floor_under_lamp(random, "nothing_twice", true, false,
                             by_ratio("the light of a floor under a lamp",
                                      {{2, "shadow rays gather the lamp, and diffuse rays that hit it again"}})),
            floor_under_lamp(random, "nothing_lost", false, false,
                             by_ratio("the light of a floor under a lamp that no shadow ray looks for",
                                      {{0, "only diffuse rays can find the lamp: it must count for them"}})),
            floor_under_lamp(random, "caustic", true, true,
                             by_ratio("the light of a floor under a lamp behind glass",
                                      {{0, "shadow rays end at the glass: what a ray hits behind it must count"}}))};
}

}  // namespace grade
