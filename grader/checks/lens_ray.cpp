#include <algorithm>

#include "asked/lens_ray.h"
#include "checks/kit/warp.h"
#include "checks/lens_ray/checks.h"
#include "statistics/blob.h"
#include "statistics/closed_forms.h"

namespace grade {

namespace {

using rt::Camera, rt::Ray, rt::vec2, rt::vec3;

Camera any_lens_camera(Generator& random) {
    const Place place = any_place(random);
    Camera camera;
    camera.eye = place.origin;
    const rt::Frame axes = chance(random, 0.3) ? rt::frame_about(exact_direction(random)) : place.axes;
    camera.right = axes.x, camera.up = axes.y, camera.back = axes.z;
    camera.tan_half_fov = between(random, 0.3, 0.9);
    camera.size = {200, 200};
    camera.lens_radius = between(random, 0.05, 0.3);
    camera.focus = between(random, 2, 8);
    return camera;
}

Row lens_row(const Camera& camera, Generator& random, vec2 (*draw_u)(Generator&) = square) {
    const Ray pinhole{camera.eye, view_direction(camera, 200.0 * square(random)), 0, rt::inf};
    return row(camera, pinhole, draw_u(random));
}

/// Where on the lens a ray starts, in lens radii.
vec2 on_lens(const Ray& ray, const Camera& camera, const Ray&, vec2) {
    const vec3 offset = (ray.origin - camera.eye) / camera.lens_radius;
    return {rt::dot(offset, camera.right), rt::dot(offset, camera.up)};
}

double plane_in_focus(const Camera& camera, vec3 d) { return camera.focus / -rt::dot(d, camera.back); }

/// Angle between the ray and the way from its origin to the point in focus; focus(camera, d) is how far along the
/// pinhole's ray that is.
template <class Focus>
RowNumber miss(Focus focus) {
    return of_call<rt::lens_ray>([=](const Ray& ray, const Camera& camera, const Ray& pinhole, vec2) {
        const double t = focus(camera, pinhole.direction);
        const vec3 due = rt::unit(pinhole.direction + (pinhole.origin - ray.origin) / t);
        return glm::length(rt::unit(ray.direction) - due);
    });
}

/// All parts of the lens get equally many rays.
Check even() {
    const auto row_with = [](Generator& draw, vec2 u) {
        Camera camera = any_lens_camera(draw);
        if (chance(draw, 0.15)) camera.focus = rt::inf;
        if (chance(draw, 0.3)) {
            camera.lens_radius = log_between(draw, 1e-3, 0.05);
            camera.eye *= camera.lens_radius;  // so near 0 that single precision tells its points apart
        }
        return row(camera, Ray{camera.eye, view_direction(camera, 200.0 * square(draw)), 0, rt::inf}, u);
    };
    return own_density(row_with, {of_call<rt::lens_ray>([](const Ray& ray) { return ray.origin; }),
                                  of_call<rt::lens_ray>([](const Ray&, const Camera& camera, const Ray&, vec2) {
                                      return 1 / (rt::pi * rt::sqr(camera.lens_radius));
                                  }),
                                  "the density of an even lens"});
}

Check in_focus() {
    const auto inputs = rows_of(128, [](Generator& random) {
        Camera camera = any_lens_camera(random);
        if (chance(random, 0.1)) camera.focus = rt::inf;
        if (chance(random, 0.3)) camera.focus = range_between(random, 0.2, 1000);
        if (chance(random, 0.2)) camera.lens_radius = log_between(random, 1e-3, 2);
        return lens_row(camera, random, square_with_ends);
    });
    const Statistic point = property(
        {.id = "D3",
         .what = "angle by which rays miss the point in focus",
         .violation = miss(plane_in_focus),
         .tolerance = 1e-4,
         .says = "rays do not meet the pinhole's ray in the plane in focus",
         .mistakes = {
             {"the focus is measured along the ray; expected along the axis: what is in focus is a plane, not a sphere",
              miss([](const Camera& camera, vec3) { return camera.focus; })},
             {"the cosine is on the wrong side: the plane in focus is further away along an oblique ray, focus/cosine",
              miss([](const Camera& camera, vec3 d) { return camera.focus * -rt::dot(d, camera.back); })},
             {"the rays of a pixel are parallel; expected that they meet in the plane in focus, at a point that is "
              "found from the pinhole, before the origin moves",
              miss([](const Camera&, vec3) { return rt::inf; })},
             {"the rays of a pixel meet behind the camera: a sign is wrong",
              miss([](const Camera& camera, vec3 d) { return -plane_in_focus(camera, d); })},
             {"the rays of a pixel meet at distance 1, whatever the focus",
              miss([](const Camera& camera, vec3 d) { return 1 / -rt::dot(d, camera.back); })},
             {"the rays of a pixel meet at twice the distance",
              miss([](const Camera& camera, vec3 d) { return 2 * plane_in_focus(camera, d); })},
             {"the rays of a pixel meet at half of the distance",
              miss([](const Camera& camera, vec3 d) { return 0.5 * plane_in_focus(camera, d); })},
             {"the rays of a pixel meet too close by the lens radius", miss([](const Camera& camera, vec3 d) {
                  return (camera.focus - camera.lens_radius) / -rt::dot(d, camera.back);
              })}}});
    return probe_check("in_focus", inputs, {point});
}

Check rays_of_lens(Generator& random) {
    const Camera camera = any_lens_camera(random);
    const auto inputs = rows_of(1024, [=](Generator& draw) { return lens_row(camera, draw); });
    const Statistic plane = property(
        {.id = "D1",
         .what = "origin off the plane of the lens by [lens radius]",
         .violation = of_call<rt::lens_ray>([](const Ray& ray, const Camera& camera, const Ray&, vec2) {
             return std::abs(rt::dot(ray.origin - camera.eye, camera.back)) / camera.lens_radius;
         }),
         .tolerance = 1e-3,
         .says = "the lens is not at right angles to the camera's axis: is it turned with the camera, along right and "
                 "up?"});
    const auto from_middle = [](vec2 p) { return p.x * p.x + p.y * p.y; };
    const RowPoint start = of_call<rt::lens_ray>(on_lens);
    const Statistic size =
        mean_of({.id = "D2",
                 .what = "mean square of the distance from the middle of the lens [lens radius^2]",
                 .number = [=](const Row& in, const Row& out) { return from_middle(start(in, out)); },
                 .truth = 0.5,
                 .hint = by_value("the mean square of the distance from the middle of the lens, in lens radii,",
                                  {{1.0 / 3, "is the square root missing? r = sqrt(u)"},
                                   {2.0 / 3, "is the lens a square?"},
                                   {0.125, "is the lens radius taken for its diameter?"},
                                   {2, "is the lens's diameter taken for its radius?"},
                                   {1, "do all rays start on the rim?"},
                                   {0.5 / rt::sqr(camera.lens_radius), "is the lens radius used?"},
                                   {0.5 * rt::sqr(camera.lens_radius), "is the lens radius squared?"},
                                   {0, "is u used? All rays start in the middle"}},
                                  0.04)});
    const Statistic spread = uniform_in_square(
        {.id = "V3",
         .what = "chi squared of the points on the lens per degree of freedom",
         .point =
             [=](const Row& in, const Row& out) {
                 const vec2 p = start(in, out);
                 return vec2(from_middle(p), turn(p.x, p.y));
             },
         .hint = always("the points are not spread evenly over the lens, the disc about camera.eye along right and up: "
                        "both coordinates of u are needed, independent of each other")});
    return probe_check("lens", inputs,
                       {plane, unit_direction<rt::lens_ray>("D1"), whole_ray<rt::lens_ray>("D1"), size, spread});
}

/// A lamp of so many pixels' radius at a film point, at distance z along the axis: a disc parallel to the film, whose
/// picture is a disc, blurred by that of the lens.
std::string lamp_at(const Camera& camera, vec2 film, double z, double pixels) {
    const vec3 d = view_direction(camera, film);
    return disc("lamp", camera.eye - z / rt::dot(d, camera.back) * d, camera.back,
                pixels / pixels_per_metre(camera, z));
}

/// Moments of the blur alone: those of a lamp's picture less what the lamp's own disc and the pixel add.
///
///     E |a + b|^2 = E a^2 + E b^2,    E |a + b|^4 = E a^4 + E b^4 + 4 E a^2 E b^2
struct Blur {
    double square = 0, fourth = 0;  // mean powers of the distance from the centre [pixel^2, pixel^4]
    double radius() const { return std::sqrt(2 * std::max(square, 0.0)); }
};

Blur blur(const rt::Image& image, const Region& region, double lamp_radius) {
    const Blob seen = blob_moments(image, region);
    const double disc = rt::sqr(lamp_radius) / 2, disc4 = std::pow(lamp_radius, 4) / 3, pixel = 1.0 / 6,
                 pixel4 = 7.0 / 180;
    Blur b;
    b.square = seen.radial_square - disc - pixel;
    b.fourth = seen.radial_kurtosis * rt::sqr(seen.radial_square) - disc4 - pixel4 -
               4 * (b.square * (disc + pixel) + disc * pixel);
    return b;
}

/// What is sharp has no blur, but for how its rim falls on the pixels.
Statistic sharp(const std::string& where, Region region, double lamp_radius, Hint hint) {
    return of_picture({.id = "D3",
                       .what = "blur in " + where + " [pixel^2]",
                       .number = [=](const rt::Image& image) { return blur(image, region, lamp_radius).square; },
                       .truth = 0,
                       .delta = 0.8,
                       .delta0 = 0.2,
                       .hint = std::move(hint)});
}

std::string lens_scene(const View& view) { return toml(view) + unsampled_lamp("lamp", 3); }

/// Three lamps, in any order from left to right: before the plane in focus, in it, and behind it.
Check depths(Generator& random) {
    const Place place = any_place(random);
    const double focus = between(random, 2, 5), nearer = between(random, 0.5, 0.7), further = between(random, 0.5, 0.6),
                 size = 3;
    View view{place({0, 0, 0}), place({0, 0, -1}), place.turned({0, 1, 0}), 30, {96, 32}};
    view.focus = focus;
    // 1/z - 1/focus is nearer/focus and -further/focus
    view.lens_radius = between(random, 6.5, 7.5) * focus / nearer / (16 / std::tan(15 * rt::pi / 180));
    const Camera camera = camera_of(lens_scene(view));
    const double before = focus / (1 + nearer), behind = focus / (1 - further);
    std::array<int, 3> left = {0, 32, 64};
    std::ranges::shuffle(left, random);
    const std::string scene = lens_scene(view) + lamp_at(camera, {left[0] + 16, 16}, before, size) +
                              lamp_at(camera, {left[1] + 16, 16}, focus, size) +
                              lamp_at(camera, {left[2] + 16, 16}, behind, size);

    const auto radius = [&](const std::string& where, int x, double z) {
        return of_picture({.id = "D1",
                           .what = "radius of the blur disc " + where + " the plane in focus, over what must be",
                           .number =
                               [=](const rt::Image& image) {
                                   return blur(image, {x, 0, 32, 32}, size).radius() / blur_radius(camera, z);
                               },
                           .delta = 0.08,
                           .hint = by_ratio("the blur disc of a lamp " + where + " the plane in focus",
                                            {{0.5, "is the lens radius taken for its diameter?"},
                                             {2, "is the lens's diameter taken for its radius?"},
                                             {std::sqrt(2.0 / 3), "is the square root of u missing?"},
                                             {std::sqrt(4.0 / 3), "is the lens a square?"},
                                             {std::sqrt(2.0), "do all rays start on the rim of the lens?"},
                                             {0, "is the lens used?"}})});
    };
    const Statistic shape = of_picture(
        {.id = "D2",
         .what = "mean fourth power over squared mean square of the blur",
         .number =
             [=](const rt::Image& image) {
                 const Blur b = blur(image, {left[0], 0, 32, 32}, size);
                 return b.fourth / rt::sqr(b.square);
             },
         .truth = 4.0 / 3,
         .delta = 0.12,
         .hint = by_value("the blur disc's mean fourth power over its squared mean square, 4/3 for a uniform disc,",
                          {{1.8, "is the square root of u missing? The middle of the lens gets too much"},
                           {1.4, "is the lens a square?"},
                           {1, "do all rays start on the rim of the lens?"}},
                          0.04)});
    return render_check(
        "depths", {scene, 16, "sobol"},
        {radius("before", left[0], before), radius("behind", left[2], behind),
         sharp("the plane in focus", {left[1], 0, 32, 32}, size,
               always("what is in the plane in focus is blurred: do all rays of a film point meet there?")),
         shape});
}

/// A lamp in the plane in focus, in a corner of a wide picture.
Check corner(Generator& random) {
    const Place place = any_place(random);
    View view{place({0, 0, 0}), place({0, 0, -1}), place.turned({0, 1, 0}), 80, {48, 48}};
    view.focus = between(random, 1, 5);
    view.lens_radius = between(random, 0.35, 0.4) * view.focus;
    const double size = 3;
    const bool right = chance(random, 0.5), low = chance(random, 0.5);
    const Camera camera = camera_of(lens_scene(view));
    const std::string scene = lens_scene(view) + lamp_at(camera, {right ? 40 : 8, low ? 40 : 8}, view.focus, size);
    const Region region{right ? 32 : 0, low ? 32 : 0, 16, 16};
    return render_check("corner", {scene, 16, "sobol"},
                        {sharp("the corner of the plane in focus", region, size, [](double value, double) {
                            return fmt::format(
                                "in the corner of the picture, what is in focus is blurred to a disc of radius {:.3g} "
                                "pixels: is the focus measured along the ray? It is along the axis",
                                std::sqrt(2 * std::max(value, 0.0)));
                        })});
}

}  // namespace

Checks check_lens_ray(Generator& random) {
    return {in_focus(),
            rays_of_lens(random),
            even(),
            depths(random),
            corner(random),
            lens_ray::two_colors(random),
            lens_ray::adding_up(random)};
}

}  // namespace grade
