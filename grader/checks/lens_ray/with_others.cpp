#include "checks/lens_ray/checks.h"

#include "checks/kit/render_check.h"
#include "statistics/blob.h"
#include "statistics/closed_forms.h"

namespace grade::lens_ray {

using rt::vec2, rt::vec3;

namespace {

/// From above, focused so that what is at the distance is blurred to a disc of so many pixels' radius.
View blurred_view(Generator& random, const Place& place, double distance, double blur, int size) {
    View view = place.from_above(distance, 20, {size, size});
    view.focus = distance * between(random, 0.55, 0.7);
    view.lens_radius = 1;
    view.lens_radius = blur / blur_radius(camera_of(view), distance);
    return view;
}

}  // namespace

/// A small white disc out of focus, under a lamp whose one half is red and whose other half is green: two lamps side by
/// side, with a card before their inner halves. What decides on the colour is the point on the lamp; what decides on
/// the place is the point on the lens.
Check two_colors(Generator& random) {
    const Place place = any_place(random);
    constexpr int size = 32;
    constexpr double radius = 2.5;  // of the disc [pixel]
    const double turn = between(random, 0, 2 * rt::pi), distance = between(random, 2, 3),
                 blur = between(random, 8, 9.5);
    const View view = blurred_view(random, place, distance, blur, size);
    // lamps above the camera, red and green; the card covers the halves that touch
    const double height = 2 * distance, half = between(random, 0.1, 0.15) * distance, card = 0.95 * height;
    const vec3 across = place.turned({std::cos(turn), std::sin(turn), 0}),
               along = place.turned({-std::sin(turn), std::cos(turn), 0});
    const auto at = [&](double x, double z) { return place({0, 0, z}) + x * across; };
    const std::string scene =
        toml(view) + material("white", {{"albedo", between(random, 0.5, 0.9)}}) + material("card", {}) +
        material("red", {{"emission", vec3(40, 0, 0)}}) + material("green", {{"emission", vec3(0, 40, 0)}}) +
        disc("white", at(0, 0), place.axes.z, radius / pixels_per_metre(camera_of(view), distance)) +
        quad("red", at(-half, height), half * across, -half * along) +
        quad("green", at(half, height), half * across, -half * along) +
        quad("card", at(0, card), half * card / height * across, 2 * half * along);

    const auto moments = [=](const rt::Image& image) {
        return color_moments(image, whole(image), vec2(0.5 * size), blur);
    };
    const auto statistic = [](const std::string& what, PictureNumber number) {
        return of_picture(
            {.id = "D4",
             .what = "red less green, " + what,
             .number = std::move(number),
             .truth = 0,
             .delta = 0.3,
             .hint = with_value(
                 "what is seen through one side of the lens is redder than through the other, by {:.3g}: does the "
                 "point on the lens go together with the point on the lamp? The lens has its own numbers u")});
    };
    return render_check(
        "two_colors", {scene, 24, "random"},
        {statistic("across the blur [blur radius]", [=](const rt::Image& i) { return moments(i).centroid.x; }),
         statistic("down the blur [blur radius]", [=](const rt::Image& i) { return moments(i).centroid.y; }),
         statistic("from the middle of the blur outwards [blur radius^2]",
                   [=](const rt::Image& i) { return moments(i).square; })});
}

/// A small lamp out of focus that flies by: the variances that pixel, lens and time add to its picture.
Check adding_up(Generator& random) {
    const Place place = any_place(random);
    constexpr int size = 20;
    const double open = between(random, 0.4, 0.8), close = open + between(random, 0.5, 1), middle = (open + close) / 2;
    const double length = between(random, 4, 5), blur = between(random, 1.8, 2.2), lamp = 1.2,
                 turn = between(random, 0, 2 * rt::pi);
    const double distance = between(random, 2, 3);
    const View view = blurred_view(random, place, distance, blur, size);
    const double pixel = 1 / pixels_per_metre(camera_of(view), distance);  // [m]
    const vec2 along(std::cos(turn), std::sin(turn));
    const vec2 step = length / (close - open) * along;
    const std::string scene = toml(view) + shutter(open, close) + unsampled_lamp("lamp", 10) +
                              disc("lamp", place(-middle * pixel * vec3(step.x, step.y, 0)), place.axes.z, lamp * pixel,
                                   place.turned(pixel * vec3(step.x, step.y, 0)));

    const auto variance = [=](const rt::Image& image, vec2 axis) {
        const Blob seen = blob_of(image);
        // y of the picture runs down
        return rt::sqr(axis.x) * seen.variance.x + rt::sqr(axis.y) * seen.variance.y -
               2 * axis.x * axis.y * seen.covariance;
    };
    const auto statistic = [=](const std::string& what, vec2 axis, double due) {
        return of_picture(
            {.id = "M4",
             .what = "variance " + what + " of a lamp out of focus, over the sum of its parts",
             .number = [=](const rt::Image& image) { return variance(image, axis) / due; },
             .delta = 0.12,
             .hint = with_value("the picture of what moves and is out of focus is {:.3g} times as wide, squared, as "
                                "pixel, lens and time make it: do they go together? The lens has its own numbers u")});
    };
    return render_check("adding_up", {scene, 64, "sobol"},
                        {statistic("along the way", along, streak_variance(length, blur, lamp)),
                         statistic("across the way", {-along.y, along.x}, streak_variance(0, blur, lamp))});
}

}  // namespace grade::lens_ray
