#include <fmt/format.h>

#include <array>

#include "asked/emission_counts.h"
#include "checks/kit/kit.h"
#include "statistics/closed_forms.h"

namespace grade {

namespace {

using rt::Event, rt::vec3;

/// Formulas of one comparison and `sampled`, each with what is wrong in it.
std::vector<Suspect<rt::emission_counts>> other_formulas() {
    constexpr std::array names = {"camera", "diffuse", "specular", "lobe", "medium"};
    std::vector<Suspect<rt::emission_counts>> all;
    for (const bool both : {true, false})
        for (const bool equal : {false, true})
            for (const bool sampled : {false, true})
                for (const Event event : {Event::diffuse, Event::camera, Event::specular, Event::lobe, Event::medium}) {
                    const auto f = [=](Event e, bool is_sampled) {
                        const bool first = (e == event) == equal, second = is_sampled == sampled;
                        return both ? first && second : first || second;
                    };
                    const std::string formula = fmt::format("the answers are those of `previous {} {} {} {}sampled`",
                                                            equal ? "==" : "!=", names[std::size_t(event)],
                                                            both ? "&&" : "||", sampled ? "" : "!");
                    const bool is_operator = both && !equal && !sampled && event == Event::diffuse;
                    all.push_back(
                        {formula + (is_operator ? "; expected `previous != diffuse || !sampled`, which is `!(previous "
                                                  "== diffuse && sampled)`"
                                    : event != Event::diffuse ? ": it is the diffuse surface that sends shadow rays"
                                                              : ": is a condition the wrong way round?"),
                         f});
                }
    return all;
}

Check truth_table() {
    const auto inputs = [](Generator&) {
        Rows rows;
        for (const Event event : {Event::camera, Event::diffuse, Event::specular, Event::lobe, Event::medium})
            for (const bool sampled : {false, true}) rows.push_back(row(event, sampled));
        return rows;
    };
    // a sampled emitter that does not count after one more kind of event
    const auto but_after = [](Event kind) {
        return [kind](bool right, Event e, bool sampled) { return right && !(sampled && e == kind); };
    };
    Formula<rt::emission_counts> all(
        {.id = "F1",
         .what = "wrong answers",
         .right = [](Event e, bool sampled) { return e != Event::diffuse || !sampled; },
         .suspects = {
             {"every emitter counts: a diffuse ray gathers again what shadow rays have gathered",
              [](Event, bool) { return true; }},
             {"no emitter counts", [](Event, bool) { return false; }},
             {"the answer is the wrong way round", [](bool right) { return !right; }},
             {"emitters are seen by the camera alone", [](Event e, bool) { return e == Event::camera; }},
             {"no emitter counts after a diffuse bounce: one that no shadow ray looks for must",
              [](Event e, bool) { return e != Event::diffuse; }},
             {"a sampled emitter never counts: the camera, mirrors, glass, lobes and media send no shadow rays",
              [](Event, bool sampled) { return !sampled; }},
             {"whether shadow rays look for the emitter is taken the wrong way round",
              [](Event e, bool sampled) { return e != Event::diffuse || sampled; }},
             {"a sampled emitter counts from the camera alone: mirrors, glass, lobes and media send no shadow rays "
              "either",
              [](Event e, bool sampled) { return e == Event::camera || !sampled; }},
             {"after glass or a mirror a sampled emitter does not count; it must: caustics are missing",
              but_after(Event::specular)},
             {"after a glossy lobe a sampled emitter does not count; it must: no shadow ray was sent",
              but_after(Event::lobe)},
             {"after a medium a sampled emitter does not count; it must: no shadow ray was sent",
              but_after(Event::medium)}}});
    for (auto& suspect : other_formulas()) all.suspects.push_back(std::move(suspect));
    Statistic right = formula(all);
    right.hint = always("the answer is wrong for some kind of path");
    return probe_check("truth_table", inputs, {right});
}

/// A floor under a lamp, perhaps with a pane of glass in between that does not bend light. However the floor's light is
/// gathered, by shadow rays or by diffuse rays that hit the lamp, it is
///
///     albedo/pi L quad_irradiance
struct FloorUnderLamp {
    std::string name;
    bool sampled = true, pane = false;
    std::string where;  // the lamp is
    KnownValue known;
};

Check floor_under_lamp(Generator& random, const FloorUnderLamp& setting) {
    const Place place = any_place(random);
    const rt::Quad lamp{place({between(random, -0.3, 0.3), between(random, -0.3, 0.3), 1}),
                        between(random, 0.6, 0.9) * place.axes.x, -between(random, 0.6, 0.9) * place.axes.y};
    const View view{place({2.5, 0, 0.8}), place({0, 0, 0}), place.turned({0, 0, 1}), 12, {24, 24}};
    const double radiance = between(random, 1, 4), albedo = between(random, 0.5, 0.9);
    std::string scene = scene_table("[render]", {{"bounces", 2}, {"solid_angle", false}}) + toml(view) +
                        material("floor", {{"albedo", albedo}}) +
                        material("lamp", {{"emission", radiance}, {"sampled", setting.sampled}}) +
                        place.floor("floor", 3) + quad("lamp", lamp);
    if (setting.pane) scene += material("pane", {{"transmittance", 1}}) + place.floor("pane", 1.5, 0.6);

    const auto due = later([=, camera = camera_of(scene)] {
        double sum = 0;
        for (int y = 0; y < view.size.y; ++y)
            for (int x = 0; x < view.size.x; ++x) {
                const double sight = over_pixel(x, y, [&](rt::vec2 film) {
                    return quad_irradiance(lamp, seen_on_plane(camera, film, place.origin, place.axes.z), place.axes.z);
                });
                sum += albedo / rt::pi * radiance * sight / (view.size.x * view.size.y);
            }
        return sum;
    });
    const Statistic light =
        of_picture({.id = "F1",
                    .what = "light of the floor, over what must be",
                    .number = [=](const rt::Image& image) { return region_mean(image, whole(image)).r / due(); },
                    .delta = 0.05,
                    .hint = by_ratio("the light of a floor under a lamp" + setting.where, {setting.known})});
    return render_check(setting.name, {scene, 32, "sobol"}, {light});
}

}  // namespace

Checks check_emission_counts(Generator& random) {
    return {
        truth_table(),
        floor_under_lamp(random, {.name = "nothing_twice",
                                  .known = {2, "shadow rays gather the lamp, and diffuse rays that hit it again"}}),
        floor_under_lamp(random, {.name = "nothing_lost",
                                  .sampled = false,
                                  .where = " that no shadow ray looks for",
                                  .known = {0, "only diffuse rays can find the lamp: it must count for them"}}),
        floor_under_lamp(random, {.name = "caustic",
                                  .pane = true,
                                  .where = " behind glass",
                                  .known = {0, "shadow rays end at the glass: what a ray hits behind it must count"}})};
}

}  // namespace grade
