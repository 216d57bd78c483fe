#include "checks/kit/figures.h"

#include <fmt/format.h>

#include "checks/kit/draw.h"
#include "checks/kit/outline.h"
#include "rt/files/scene_reader.h"
#include "statistics/projection.h"

namespace grade {

namespace {

using rt::Quad, rt::vec2, rt::vec3;

constexpr const char* lamp = "[materials.lamp]\nemission = 1\n\n";

View view_down(const Place& place, double height, double vfov) {
    return {place({0, 0, height}), place({0, 0, 0}), place.turned({0, 1, 0}), vfov, {48, 40}};
}

/// A quad near the middle of the plane z, turned by any angle, whose front is up.
Quad any_quad(Generator& random, const Place& place, double z, double size) {
    const double angle = between(random, 0.1, 1.4), x = between(random, -0.3, 0.3), y = between(random, -0.2, 0.2);
    const double width = between(random, 0.7, 1), height = between(random, 0.4, 0.7);
    return {place(size * vec3(x, y, 0) + vec3(0, 0, z)),
            size * width * place.turned({std::cos(angle), std::sin(angle), 0}),
            size * height * place.turned({-std::sin(angle), std::cos(angle), 0})};
}

std::string shape(const std::string& material, const Quad& q) { return quad(material, q.center, q.u, q.v); }

std::string triangle(const std::string& material, vec3 a, vec3 b, vec3 c) {
    return fmt::format("[[shape]]\ntype = \"triangle\"\na = {}\nb = {}\nc = {}\nmaterial = \"{}\"\n\n", toml(a),
                       toml(b), toml(c), material);
}

}  // namespace

Check slanted_quad(Generator& random) {
    const Place place = any_place(random);
    const Quad q = any_quad(random, place, 0, 1);
    return figure_check("slanted_quad", toml(view_down(place, 5, between(random, 32, 45))) + lamp + shape("lamp", q),
                        "quad", [q](const rt::Camera& camera) -> Sight {
                            return [=](vec2 film) {
                                return on_quad(q, camera.eye, view_direction(camera, film)) ? 1.0 : 0.0;
                            };
                        });
}

Check silhouette(Generator& random) {
    const Place place = any_place(random);
    const vec3 center = place({between(random, -0.5, 0.5), between(random, -0.4, 0.4), 0});
    const double radius = between(random, 0.7, 1.1);
    return figure_check(
        "silhouette", toml(view_down(place, 5, 40)) + lamp + sphere("lamp", center, radius), "sphere",
        [=](const rt::Camera& camera) -> Sight {
            return [=](vec2 film) {
                return glm::length(rt::cross(center - camera.eye, view_direction(camera, film))) < radius ? 1.0 : 0.0;
            };
        });
}

Check two_triangles(Generator& random) {
    const Place place = any_place(random);
    const Quad q = any_quad(random, place, 0, 1);
    const vec3 a = q.center - q.u - q.v, b = q.center + q.u - q.v, c = q.center + q.u + q.v, d = q.center - q.u + q.v;
    // no shadow ray looks for a triangle
    const std::string scene = toml(view_down(place, 5, 40)) + "[materials.lamp]\nemission = 1\nsampled = false\n\n" +
                              triangle("lamp", a, b, c) + triangle("lamp", a, c, d);
    Check check = figure_check("two_triangles", scene, "pair of triangles", [q](const rt::Camera& camera) -> Sight {
        return [=](vec2 film) { return on_quad(q, camera.eye, view_direction(camera, film)) ? 1.0 : 0.0; };
    });
    Statistic seam = of_picture("A1", "brightest pixel, off 1 by", [](const rt::Image& image) {
        double most = 0;
        for (const rt::Color& c : image.pixels) most = std::max(most, c.x);
        return std::abs(most - 1);
    }, 0, 1e-9, always("the figure's radiance is 1"));
    seam.exact = true;
    check.statistics.push_back(seam);
    return check;
}

Check mirror_image(Generator& random) {
    // a camera looks at a mirror, z = 0, at an angle; the quad stands before the mirror
    const Place place = any_place(random);
    const double angle = between(random, 0.2, 1.3), width = between(random, 0.35, 0.45),
                 height = between(random, 0.2, 0.3);
    const vec3 y = place.axes.y, z = place.axes.z;
    const Quad q{place({2.2, between(random, -0.2, 0.2), between(random, 1.1, 1.4)}),
                 width * (std::cos(angle) * z + std::sin(angle) * y),
                 height * (std::cos(angle) * y - std::sin(angle) * z)};
    const View view{place({-2.5, 0, 1.5}), place({0.2, 0, 0}), z, 34, {48, 40}};
    // the front of the quad, u x v, looks back along -x
    const std::string scene = toml(view) + lamp + "[materials.mirror]\nreflectance = 0.8\n\n" +
                              quad("mirror", place({0, 0, 0}), 1.5 * place.axes.x, 1.5 * place.axes.y) +
                              quad("lamp", q.center, q.u, q.v);
    const vec3 origin = place.origin, normal = place.axes.z;
    return figure_check("mirror_image", scene, "mirror image",
                        [=](const rt::Camera& camera) -> Sight {
                            return [=](vec2 film) {
                                const vec3 d = view_direction(camera, film),
                                           p = seen_on_plane(camera, film, origin, normal);
                                if (rt::dot(d, normal) >= 0) return on_quad(q, camera.eye, d) ? 1.0 : 0.0;
                                const vec3 across = p - origin;
                                const bool mirrored = std::abs(rt::dot(across, place.axes.x)) <= 1.5 &&
                                                      std::abs(rt::dot(across, place.axes.y)) <= 1.5;
                                if (on_quad(q, camera.eye, d)) return 1.0;
                                // the image stands behind the mirror
                                const vec3 turned = d - 2 * rt::dot(d, normal) * normal;
                                return mirrored && on_quad(q, p, turned) ? 0.8 : 0.0;
                            };
                        });
}

namespace {

/// A bright quad on the floor, under a slab of glass that the camera looks through at an angle. The slab moves the quad
/// (F4), and lets through (1 - F)^2 of its light: nothing is mirrored, as its reflectance is 0.
Check slab(Generator& random, const std::string& name) {
    const Place place = any_place(random);
    const double ior = between(random, 1.3, 1.9), thickness = between(random, 0.6, 0.9), bottom = 0.3;
    const Quad q = any_quad(random, place, 0, 0.7);
    const View view{place({-3.5, 0, 3.5}), place({0.2, 0, 0}), place.axes.z, 28, {48, 40}};
    const std::string scene =
        toml(view) + lamp + fmt::format("[materials.glass]\ntransmittance = 1\nior = {}\n\n", toml(ior)) +
        shape("lamp", q) + quad("glass", place({0, 0, bottom + thickness}), 6.0 * place.axes.x, 6.0 * place.axes.y) +
        quad("glass", place({0, 0, bottom}), 6.0 * place.axes.x, -6.0 * place.axes.y);
    const vec3 normal = place.axes.z;
    return figure_check(name, scene, "quad behind the glass",
                        [=](const rt::Camera& camera) -> Sight {
                            return [=](vec2 film) {
                                const vec3 d = view_direction(camera, film);
                                const double angle = std::acos(-rt::dot(d, normal)),
                                             inside = std::asin(std::sin(angle) / ior);
                                const vec3 along = rt::unit(d - rt::dot(d, normal) * normal);
                                // sideways at right angles to the ray, towards the normal's side
                                const vec3 sideways = -std::cos(angle) * along - std::sin(angle) * normal;
                                if (!on_quad(q, camera.eye + thickness * slab_shift(angle, ior) * sideways, d))
                                    return 0.0;
                                const double s = rt::sqr(std::sin(angle - inside) / std::sin(angle + inside)),
                                             p = rt::sqr(std::tan(angle - inside) / std::tan(angle + inside));
                                return rt::sqr(1 - (s + p) / 2);
                            };
                        });
}

}  // namespace

Check through_a_slab(Generator& random) { return slab(random, "through_a_slab"); }

Check bright_slab(Generator& random) { return slab(random, "light_through_a_slab"); }

/// A ball of glass and a bubble of air in glass, where light comes from everywhere alike: neither can be seen. Beyond a
/// part of its radius the bubble reflects all light. Paths may be so long that hardly one ends in the glass: that would be
/// noise of few pixels.
Check invisible_glass(Generator& random) {
    const Place place = any_place(random);
    const double ior = between(random, 1.3, 1.8), around = log_between(random, 0.3, 3);
    const auto glass = [](const std::string& name, double index) {
        return fmt::format("[materials.{}]\nreflectance = 1\ntransmittance = 1\nior = {}\n\n", name, toml(index));
    };
    const View view{
        place({0, 0, 8}), place({0, 0, 0}), place.turned({0, 1, 0}), 2 * std::atan(1.2 / 8) * 180 / rt::pi, {48, 24}};
    const std::string scene = fmt::format("environment = {}\n\n[render]\ndepth = 4096\n\n", toml(around)) + toml(view) +
                              glass("glass", ior) + glass("air", 1 / ior) + sphere("glass", place({-1.2, 0, 0}), 1) +
                              sphere("air", place({1.2, 0, 0}), 1);
    const auto light = [=](const std::string& thing, Region region, const std::string& question) {
        return of_picture(
            "F3", "radiance of " + thing + ", over that of its surroundings",
            [=](const rt::Image& image) { return brightness(region_mean(image, region)) / around; }, 1, 0.01,
            [=](double value, double) {
                return fmt::format(
                    "{} where light comes from everywhere alike must be invisible, but its radiance is {:.3g} times "
                    "that of its "
                    "surroundings: {}",
                    thing, value, question);
            });
    };
    return render_check(
        "invisible_glass", {scene, 4, "sobol"},
        {light("lossless glass", {2, 2, 20, 20}, "are reflected and refracted shares fresnel and 1 - fresnel?"),
         light("a bubble of air in lossless glass", {26, 2, 20, 20},
               "is all light reflected where none can be refracted?")});
}

/// Noise of N samples at the edges of a bright quad, over that of independent ones: N (L - p)^2 / (p (1 - p)), p the
/// share of the pixel that the quad covers.
Check edge_noise(Generator& random) {
    constexpr int samples = 16;
    const Place place = any_place(random);
    const Quad q = any_quad(random, place, 0, 1);
    const std::string scene = toml(view_down(place, 5, 40)) + lamp + shape("lamp", q);
    const rt::Camera camera = rt::parse_scene(scene, "edge_noise").camera;
    struct Edge {
        int x, y;
        double covered;
    };
    std::vector<Edge> edges;
    for (int y = 0; y < camera.size.y; ++y)
        for (int x = 0; x < camera.size.x; ++x) {
            double covered = 0;
            for (int part = 0; part < 16; ++part)
                covered += over_pixel(0, 0, [&](vec2 share) {
                    const vec2 film = vec2(x, y) + (vec2(part % 4, part / 4) + share) / 4.0;
                    return on_quad(q, camera.eye, view_direction(camera, film)) ? 1.0 : 0.0;
                }) / 16;
            if (covered > 0.15 && covered < 0.85) edges.push_back({x, y, covered});
        }
    Statistic noise = of_picture(
        "G2", "noise at edges, over that of independent samples",
        [edges](const rt::Image& image) {
            double sum = 0;
            for (const Edge& e : edges)
                sum += samples * rt::sqr(image.at(e.x, e.y).x - e.covered) / (e.covered * (1 - e.covered));
            return sum / double(edges.size());
        },
        0.2, 0.25,
        [](double value, double) {
            return fmt::format(
                "the noise at edges is {:.2g} of that of independent samples; cells leave about 0.2 with 16 samples: "
                "does each sample fall in a cell of "
                "its own, anywhere in it?",
                value);
        });
    noise.delta0 = 0.1;
    return render_check("edge_noise", {scene, samples, "stratified"}, {noise});
}

/// A matt floor under a sky of radiance 1 has its albedo's radiance, whatever direction is drawn: no noise (V1).
Check open_sky(Generator& random) {
    const Place place = any_place(random);
    const double albedo = between(random, 0.3, 0.9);
    const std::string scene = "environment = 1\n\n" +
                              toml(View{place({2, 1, 3}), place({0, 0, 0}), place.axes.z, 30, {24, 24}}) +
                              fmt::format("[materials.floor]\nalbedo = {}\n\n", toml(albedo)) +
                              quad("floor", place({0, 0, 0}), 50.0 * place.axes.x, 50.0 * place.axes.y);
    Statistic light = of_picture(
        "F1", "radiance of the floor, over its albedo",
        [=](const rt::Image& image) { return brightness(region_mean(image, whole(image))) / albedo; }, 1, 0.01,
        by_ratio("the light of a floor under an even sky",
                 {{0.5, "is the density twice too large?"}, {2, "is the density twice too small?"}},
                 "the density is cos(theta)/pi of the direction that is returned"));
    Statistic noise = of_picture(
        "V1", "largest deviation of a pixel from the albedo",
        [=](const rt::Image& image) {
            double most = 0;
            for (const rt::Color& c : image.pixels) most = std::max(most, std::abs(c.x / albedo - 1));
            return most;
        },
        0, 2e-3,
        always(
            "directions drawn as the cosine leave no noise under an even sky: is the density that of the direction?"));
    noise.exact = true;
    return render_check("open_sky", {scene, 4, "random"}, {light, noise});
}

}  // namespace grade
