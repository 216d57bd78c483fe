#include "asked/direct_light.h"
#include "checks/kit/kit.h"
#include "checks/kit/reflection_model.h"
#include "statistics/blob.h"
#include "statistics/closed_forms.h"
#include "statistics/regression.h"

namespace grade {

namespace {

using rt::Color, rt::LightSample, rt::Material, rt::vec2, rt::vec3;

auto estimate(Model model) {
    return [=](const Material& m, Color radiance, const LightSample& s, vec3 n, vec3 c) {
        return Color(s.density > 0 ? reflected(m, n, s.direction, c, model) * radiance / s.density : Color(0));
    };
}

/// The right answer times a factor of the sample; 0 stays.
template <class Factor>
auto times(Factor factor) {
    return [=](Color right, const Material&, Color, const LightSample& s, vec3, vec3) {
        return s.density > 0 ? right * factor(s) : right;
    };
}

/// Integral of f(direction) over the directions from p to a quad that is seen from its front.
template <class F>
double over_quad(const rt::Quad& lamp, vec3 p, F f) {
    constexpr int n = 6;
    const vec3 normal = rt::cross(lamp.u, lamp.v);  // as long as a quarter of the area
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < n; ++k) {
            const vec3 d = lamp.center + ((2 * i + 1.0) / n - 1) * lamp.u + ((2 * k + 1.0) / n - 1) * lamp.v - p;
            const double square = rt::dot(d, d);
            sum += f(d / std::sqrt(square)) * std::max(0.0, -rt::dot(d, normal)) * 4 / (n * n) /
                   (square * std::sqrt(square));
        }
    return sum;
}

/// A long floor under a small lamp that turns its front to it: from right below to far away. Light over what must be,
/// against the cosine at the floor.
Check lit_floor(Generator& random) {
    const Place place = any_place(random);
    const rt::Frame& axes = place.axes;
    const rt::Quad lamp{place({0, 0, 1}),
                        between(random, 0.15, 0.25) * rt::unit(axes.x + 0.7 * axes.z),  // it faces x, and down
                        -between(random, 0.15, 0.25) * axes.y};
    const Color albedo(0.8, 0.5, 0.2), radiance = box(random, 5, 10);
    const View view{place({2.5, 0, 6}), place({2.5, 0, 0}), place.turned({0, 1, 0}), 8, {60, 10}};
    const std::string scene = toml(view) + material("floor", {{"albedo", albedo}}) +
                              material("lamp", {{"emission", radiance}}) +
                              quad("floor", place({2, 0, 0}), 10.0 * axes.x, 10.0 * axes.y) + quad("lamp", lamp);

    // groups of columns
    const rt::Camera camera = camera_of(scene);
    constexpr int groups = 12, columns = 5, rows = 10;
    std::vector<double> log_cosine(groups), due(groups);
    for (int g = 0; g < groups; ++g) {
        for (int x = g * columns; x < (g + 1) * columns; ++x)
            for (int y = 0; y < rows; ++y) {
                const vec3 p = seen_on_plane(camera, {x + 0.5, y + 0.5}, place.origin, axes.z);
                due[std::size_t(g)] += quad_irradiance(lamp, p, axes.z) / rt::pi / (columns * rows);
                log_cosine[std::size_t(g)] += std::log(rt::dot(rt::unit(lamp.center - p), axes.z)) / (columns * rows);
            }
    }
    const auto line = [=](const rt::Image& image, int channel) {
        std::vector<double> y;
        for (int g = 0; g < groups; ++g) {
            const Color seen = region_mean(image, {g * columns, 0, columns, rows}) / (albedo * radiance);
            y.push_back(std::log((channel < 0 ? brightness(seen) : seen[channel]) / due[std::size_t(g)]));
        }
        return fit_line(log_cosine, y);
    };
    std::vector<Statistic> statistics = rgb([&](int c, const std::string& name) {
        return of_picture({.id = "L1",
                           .what = name + " light of the floor, a factor off",
                           .number = [=](const rt::Image& i) { return std::exp(line(i, c).intercept); },
                           .delta = 0.06,
                           .hint = by_ratio("the " + name + " light of a floor",
                                            {{rt::pi, "is 1/pi missing? r_d = albedo/pi"},
                                             {1 / rt::pi, "does 1/pi come twice?"},
                                             {0.5, "does 1/(2 pi) stand for 1/pi?"},
                                             {1 / albedo[c], "is the albedo missing?"},
                                             {albedo[c], "does the albedo come twice?"},
                                             {1 / radiance[c], "is the radiance missing?"}},
                                            "expected albedo/pi x radiance x cosine / density")});
    });
    statistics.insert(
        statistics.begin(),
        of_picture({.id = "L2",
                    .what = "exponent of the cosine that is too many or missing",
                    .number = [=](const rt::Image& i) { return line(i, -1).slope; },
                    .truth = 0,
                    .delta = 0.1,
                    .hint = by_value("the light of a floor, over what it must be, goes with the cosine to the power",
                                     {{-1, "is the cosine at the surface missing?"},
                                      {1, "does the cosine at the surface come twice?"}},
                                     0.1)}));
    return render_check("lit_floor", {scene, 32, "sobol"}, statistics);
}

/// The highlight of a lamp on a polished floor that is black otherwise.
Check lamp_highlight(Generator& random) {
    const Place place = any_place(random);
    const rt::Frame& axes = place.axes;
    const double shininess = between(random, 15, 30), angle = between(random, 0.5, 0.8),
                 specular = between(random, 0.3, 0.9), radiance = between(random, 5, 10);
    const vec3 to_lamp = place.turned({std::sin(angle), 0, std::cos(angle)});
    const rt::Frame facing = rt::frame_about(-to_lamp);
    const rt::Quad lamp{place({0, 0, 0}) + 4.0 * to_lamp, 0.4 * facing.x, 0.4 * facing.y};
    const View view{
        place({-4 * std::sin(angle), 0, 4 * std::cos(angle)}), place({0, 0, 0}), place.turned({0, 0, 1}), 40, {24, 24}};
    const std::string scene = toml(view) + material("floor", {{"specular", specular}, {"shininess", shininess}}) +
                              material("lamp", {{"emission", radiance}}) + place.floor("floor", 100) +
                              quad("lamp", lamp);

    const rt::Camera camera = camera_of(scene);
    const auto light_at = [=](vec2 film, double exponent) {
        const vec3 d = view_direction(camera, film), mirrored = d - 2 * rt::dot(d, axes.z) * axes.z;
        return over_quad(lamp, seen_on_plane(camera, film, place.origin, axes.z), [&](vec3 w) {
            const double along = rt::dot(w, mirrored);
            return along > 0 && rt::dot(w, axes.z) > 0 ? specular * radiance * std::pow(along, exponent) : 0.0;
        });
    };
    const auto due = [=](double exponent) {
        return moments_of_middles(camera, [&](vec2 film) { return light_at(film, exponent); });
    };
    const Blob right = due(shininess);
    const auto width_of = [&](double exponent) { return due(exponent).radial_square / right.radial_square; };
    return render_check(
        "highlight", {scene, 32, "sobol"},
        {of_picture({.id = "L1",
                     .what = "light of the highlight, over what must be",
                     .number = [=](const rt::Image& i) { return blob_of(i).mass / right.mass; },
                     .delta = 0.06,
                     .hint = by_ratio("the light of the highlight",
                                      {{0, "the highlight is missing"},
                                       {1 / rt::pi, "is the highlight divided by pi?"},
                                       {std::cos(angle), "does the highlight have a cosine too many?"}},
                                      "expected r_s (r . c)^a x radiance / density")}),
         of_picture(
             {.id = "L1",
              .what = "mean square width of the highlight, over what must be",
              .number = [=](const rt::Image& i) { return blob_of(i).radial_square / right.radial_square; },
              .delta = 0.05,
              .hint = by_ratio("the mean square width of the highlight",
                               {{width_of(2 * shininess), "is the exponent 2a?"},
                                {width_of(shininess / 2), "is the exponent a/2?"},
                                {width_of(shininess / 4), "is it Blinn's (n . h)^a? Expected Phong's (r . c)^a"}})})});
}

/// Samples of any kind, extreme highlights, and light that grazes the surface.
std::function<Rows(Generator&)> any_samples() {
    const auto any_sample = [](Generator& random) {
        Material m = any_material(random);
        m.albedo = box(random, 0.1, 0.9), m.specular = chance(random, 0.7) ? box(random, 0.1, 0.9) : Color(0);
        m.shininess = log_between(random, 2, 60);
        const Color radiance = box(random, 1, 20);
        const vec3 n = scene_direction(random), d = light_direction(random, n);
        const vec3 c = viewer(random, n, d);
        // lamps that are small or far away are bright
        const bool far = chance(random, 0.25);
        const double density = far                   ? range_between(random, 20, 1e6)
                               : chance(random, 0.1) ? 0
                                                     : range_between(random, 1e-5, 20);
        const LightSample sample{d, log_between(random, 0.3, 10), density};
        return row(m, brightness_of_light(random) * (far ? density : 1) * radiance, sample, n, c);
    };
    const auto highlights = [](Generator& random) {
        const auto [m, n, d, c] = extreme_highlight(random);
        return row(m, box(random, 1, 20), LightSample{d, 1, between(random, 0.5, 2)}, n, c);
    };
    const auto flat_highlights = [](Generator& random) {
        const auto [m, n, d, c] = extreme_highlight(random, true);
        return row(m, box(random, 1, 20), LightSample{d, 1, between(random, 0.5, 2)}, n, c);
    };
    const auto grazing = [](Generator& random, double cosine) {
        Material m;
        m.albedo = box(random, 0.1, 0.9);
        const vec3 n = scene_direction(random);
        return row(m, box(random, 1, 20), LightSample{grazing_direction(random, n, cosine), 1, 1}, n, n);
    };
    const auto channels = rows_of_channels(3, [](Generator& random, int, auto change) {
        Material m;
        m.albedo = change(0, box(random, 0.1, 0.9)), m.specular = change(1, box(random, 0.1, 0.9));
        m.shininess = chance(random, 0.3) ? between(random, 0.1, 1) : log_between(random, 2, 60);
        const vec3 n = scene_direction(random), d = tilted(random, n, between(random, 0, 1.4));
        const Color radiance = change(2, box(random, 0.1, 20));
        return row(m, radiance, LightSample{d, 1, between(random, 0.5, 2)}, n, viewer(random, n, d));
    });
    const auto all_highlights = rows_then(rows_of(64, highlights), rows_of(4, flat_highlights));
    return rows_then(rows_then(rows_of(96, any_sample), all_highlights),
                     rows_then(rows_of_decades(lowest_grazing, highest_grazing, 2, grazing), channels));
}

}  // namespace

Checks check_direct_light(Generator& random) {
    Formula<rt::direct_light> radiance{
        .id = "L1",
        .what = "radiance, off by",
        .tolerance = 1e-6,
        .right = estimate({}),
        .suspects = {{"the density is ignored: the sample must be divided by it",
                      times([](const LightSample& s) { return s.density; })},
                     {"the sample is multiplied by its density; expected divided",
                      times([](const LightSample& s) { return s.density * s.density; })},
                     {"1/r^2 counts twice: it is part of the density per solid angle",
                      times([](const LightSample& s) { return 1 / (s.distance * s.distance); })},
                     {"the highlight is not divided by the density",
                      [](Color right, const Material& m, Color l, const LightSample& s, vec3 n, vec3 c) {
                          if (s.density <= 0) return right;
                          const Color highlight = reflected(m, n, s.direction, c, {.diffuse = false}) * l;
                          return right - highlight / s.density + highlight;
                      }},
                     {"ambient light is added to each sample: it is none of a lamp's",
                      [](Color right, const Material& m, Color l, const LightSample& s, vec3, vec3) {
                          return s.density > 0 ? right + m.ambient * l / s.density : right;
                      }},
                     {"a sample with density 0 must add nothing: it gives inf or nan",
                      [](Color right, const Material&, Color, const LightSample& s, vec3, vec3) {
                          return s.density > 0 ? right : Color(NAN);
                      }}}};
    for (const ModelMistake& mistake : reflection_mistakes)
        if (mistake.model.ambient) radiance.suspects.push_back({mistake.words, estimate(mistake.model)});
    const Statistic horizon =
        property({.id = "L4",
                  .what = "radiance of light below the horizon",
                  .violation = of_call<rt::direct_light>(
                      [](Color seen, const Material&, Color, const LightSample& s, vec3 n, vec3) {
                          return rt::dot(s.direction, n) < 0 ? rt::largest(seen) : 0.0;
                      }),
                  .says = "light from below the horizon must give exactly 0, diffuse and highlight"});
    return {probe_check("one_sample", any_samples(), {formula(radiance), horizon}), lit_floor(random),
            lamp_highlight(random)};
}

}  // namespace grade
