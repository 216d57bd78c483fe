#include <fmt/format.h>

#include <array>

#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/reflection_model.h"
#include "checks/kit/render_check.h"
#include "rt/files/scene_reader.h"
#include "statistics/blob.h"
#include "statistics/irradiance.h"
#include "statistics/regression.h"

namespace grade {

namespace {

using rt::Color, rt::LightSample, rt::Material, rt::vec2, rt::vec3;

/// f(reflected share, radiance, sample) for a model that may be wrong.
RowFunction estimate(
    Model model, std::function<Color(Color, const LightSample&)> over = [](Color c, const LightSample& s) {
        return c / s.density;
    }) {
    return of<Material, Color, LightSample, vec3, vec3>(
        [=](const Material& m, Color radiance, const LightSample& s, vec3 n, vec3 c) {
            return Color(s.density > 0 ? over(reflected(m, n, s.direction, c, model) * radiance, s) : Color(0));
        });
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
    const rt::Color albedo(0.8, 0.5, 0.2), radiance = box(random, 5, 10);
    const View view{place({2.5, 0, 6}), place({2.5, 0, 0}), place.turned({0, 1, 0}), 8, {60, 10}};
    const std::string scene = toml(view) +
                              fmt::format("[materials.floor]\nalbedo = {}\n\n[materials.lamp]\nemission = {}\n\n",
                                          toml(albedo), toml(radiance)) +
                              quad("floor", place({2, 0, 0}), 10.0 * axes.x, 10.0 * axes.y) +
                              quad("lamp", lamp.center, lamp.u, lamp.v);

    // groups of columns
    const rt::Camera camera = rt::parse_scene(scene, "floor").camera;
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
            const rt::Color seen = region_mean(image, {g * columns, 0, columns, rows}) / (albedo * radiance);
            y.push_back(std::log((channel < 0 ? brightness(seen) : seen[channel]) / due[std::size_t(g)]));
        }
        return fit_line(log_cosine, y);
    };
    std::vector<Statistic> statistics = {of_picture(
        "L2", "exponent of the cosine that is too many or missing",
        [=](const rt::Image& i) { return line(i, -1).slope.value; }, 0, 0.1,
        by_value("the light of a floor, over what it must be, goes with the cosine to the power",
                 {{-1, "is the cosine at the surface missing?"}, {1, "does the cosine at the surface come twice?"}},
                 0.1))};
    for (int c = 0; c < 3; ++c) {
        const std::string name = std::array{"red", "green", "blue"}[std::size_t(c)];
        statistics.push_back(of_picture(
            "L1", name + " light of the floor, a factor off",
            [=](const rt::Image& i) { return std::exp(line(i, c).intercept.value); }, 1, 0.06,
            by_ratio("the " + name + " light of a floor",
                     {{rt::pi, "is 1/pi missing? r_d = albedo/pi"},
                      {1 / rt::pi, "does 1/pi come twice?"},
                      {0.5, "does 1/(2 pi) stand for 1/pi?"},
                      {1 / albedo[c], "is the albedo missing?"},
                      {albedo[c], "does the albedo come twice?"},
                      {1 / radiance[c], "is the radiance missing?"}},
                     "expected albedo/pi x radiance x cosine / density")));
    }
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
    const std::string scene =
        toml(view) +
        fmt::format("[materials.floor]\nspecular = {}\nshininess = {}\n\n[materials.lamp]\nemission = {}\n\n",
                    toml(specular), toml(shininess), toml(radiance)) +
        quad("floor", place({0, 0, 0}), 100.0 * axes.x, 100.0 * axes.y) + quad("lamp", lamp.center, lamp.u, lamp.v);

    const rt::Camera camera = rt::parse_scene(scene, "highlight").camera;
    const auto due = [=](double exponent) {
        rt::Image image(camera.size.x, camera.size.y);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                const vec2 film(x + 0.5, y + 0.5);
                const vec3 d = view_direction(camera, film), mirrored = d - 2 * rt::dot(d, axes.z) * axes.z;
                image.at(x,
                         y) = rt::Color(over_quad(lamp, seen_on_plane(camera, film, place.origin, axes.z), [&](vec3 w) {
                    const double along = rt::dot(w, mirrored);
                    return along > 0 && rt::dot(w, axes.z) > 0 ? specular * radiance * std::pow(along, exponent) : 0.0;
                }));
            }
        Blob blob = blob_moments(image, whole(image));
        blob.radial_square += 1.0 / 6;  // a pixel is the mean over its area, not its centre's value
        return blob;
    };
    const Blob right = due(shininess);
    const auto seen = [](const rt::Image& image) { return blob_moments(image, whole(image)); };
    const auto width_of = [&](double exponent) { return due(exponent).radial_square / right.radial_square; };
    return render_check(
        "highlight", {scene, 32, "sobol"},
        {of_picture(
             "L1", "light of the highlight, over what must be",
             [=](const rt::Image& i) { return seen(i).mass / right.mass; }, 1, 0.06,
             by_ratio("the light of the highlight",
                      {{0, "the highlight is missing"},
                       {1 / rt::pi, "is the highlight divided by pi?"},
                       {std::cos(angle), "does the highlight have a cosine too many?"}},
                      "expected r_s (r . c)^a x radiance / density")),
         of_picture(
             "L1", "mean square width of the highlight, over what must be",
             [=](const rt::Image& i) { return seen(i).radial_square / right.radial_square; }, 1, 0.05,
             by_ratio("the mean square width of the highlight",
                      {{width_of(2 * shininess), "is the exponent 2a?"},
                       {width_of(shininess / 2), "is the exponent a/2?"},
                       {width_of(shininess / 4), "is it Blinn's (n . h)^a? Expected Phong's (r . c)^a"}}))});
}

}  // namespace

Checks check_direct_light(Generator& random) {
    const auto inputs = rows_of(96, [](Generator& random) {
        Material m;
        m.albedo = box(random, 0.1, 0.9);
        if (chance(random, 0.7)) m.specular = box(random, 0.1, 0.9);
        m.shininess = log_between(random, 2, 60);
        const Color radiance = box(random, 1, 20);
        const vec3 n = direction(random), d = tilted(random, n, light_angle(random));
        const vec3 c = viewer(random, n, d);
        const LightSample sample{d, log_between(random, 0.3, 10),
                                 chance(random, 0.1) ? 0 : log_between(random, 0.05, 20)};
        return row(m, radiance, sample, n, c);
    });
    std::vector<Suspect> suspects = {
        {"the density is ignored: the sample must be divided by it",
         estimate({}, [](Color c, const LightSample&) { return c; })},
        {"the sample is multiplied by its density; expected divided",
         estimate({}, [](Color c, const LightSample& s) { return c * s.density; })},
        {"1/r^2 counts twice: it is part of the density per solid angle",
         estimate({}, [](Color c, const LightSample& s) { return c / (s.density * s.distance * s.distance); })},
        {"the highlight is not divided by the density",
         of<Material, Color, LightSample, vec3, vec3>(
             [](const Material& m, Color l, const LightSample& s, vec3 n, vec3 c) {
                 Model diffuse, highlight;
                 diffuse.highlight = highlight.diffuse = false;
                 return Color(s.density > 0 ? reflected(m, n, s.direction, c, diffuse) * l / s.density +
                                                  reflected(m, n, s.direction, c, highlight) * l
                                            : Color(0));
             })},
        {"a sample with density 0 must add nothing: it gives inf or nan",
         of<Material, Color, LightSample, vec3, vec3>(
             [](const Material& m, Color l, const LightSample& s, vec3 n, vec3 c) {
                 return Color(s.density > 0 ? reflected(m, n, s.direction, c, {}) * l / s.density : Color(NAN));
             })}};
    for (const Mistake& mistake : reflection_mistakes())
        if (mistake.model.ambient) suspects.push_back({mistake.words, estimate(mistake.model)});
    Statistic horizon = property("L4", "radiance of light below the horizon",
        [](const Row& in, const Row& out) {
            const auto sample = argument<2, Material, Color, LightSample, vec3, vec3>(in);
            const auto n = argument<3, Material, Color, LightSample, vec3, vec3>(in);
            return rt::dot(sample.direction, n) < 0 ? rt::largest(from_row<Color>(out)) : 0.0;
        },
        0, "light from below the horizon must give exactly 0, diffuse and highlight");
    return {
        probe_check("one_sample", inputs, {formula("L1", "radiance, off by", estimate({}), 1e-4, suspects), horizon}),
        lit_floor(random), lamp_highlight(random)};
}

}  // namespace grade
