#include "asked/moved.h"
#include "checks/kit/kit.h"
#include "statistics/blob.h"

namespace grade {

namespace {

using rt::vec2, rt::vec3;

Check points() {
    const auto inputs = rows_of(96, [](Generator& random) {
        if (chance(random, 0.2)) {  // it passes close by the origin: what is left of both has few digits in `float`
            const vec3 velocity = box(random, -3, 3);
            const double time = between(random, -2, 4);
            return row(box(random, -1e-3, 1e-3) - time * velocity, velocity, time);
        }
        if (chance(random, 0.2))  // slowly, or for a moment
            return row(box(random, -1, 1), log_between(random, 1e-3, 1) * box(random, -3, 3),
                       (chance(random, 0.3) ? -1 : 1) * log_between(random, 1e-3, 1));
        const vec3 point = box(random, -5, 5),
                   velocity = chance(random, 0.1)
                                  ? vec3(0)
                                  : (chance(random, 0.3) ? range_between(random, 1, 1e3) : 1) * box(random, -3, 3);
        const double longer = chance(random, 0.3) ? range_between(random, 1, 1e3) : 1;
        const double time = chance(random, 0.1) ? 0 : longer * between(random, -2, 4);
        return row(point, velocity, time);
    });
    const Statistic right = formula<rt::moved>(
        {.id = "M1",
         .what = "point, off by",
         .tolerance = 1e-5,
         .right = [](vec3 p, vec3 v, double t) { return p + t * v; },
         .suspects = {
             {"the point does not move", [](vec3 p, vec3, double) { return p; }},
             {"the time is not used: the point is always where it is after 1 s",
              [](vec3 p, vec3 v, double) { return p + v; }},
             {"the point moves backwards", [](vec3 p, vec3 v, double t) { return p - t * v; }},
             {"only the way is returned; expected the point after it", [](vec3, vec3 v, double t) { return t * v; }},
             {"the speed is not used, the direction of the velocity alone",
              [](vec3 p, vec3 v, double t) { return p + t * rt::unit(v); }},
             {"only the x component moves", [](vec3 p, vec3 v, double t) { return p + t * vec3(v.x, 0, 0); }},
             {"the z component does not move", [](vec3 p, vec3 v, double t) { return p + t * vec3(v.x, v.y, 0); }},
             {"times before 0 are clamped: a point moves then too",
              [](vec3 p, vec3 v, double t) { return p + std::max(t, 0.0) * v; }},
             {"the way grows with the square of the time", [](vec3 p, vec3 v, double t) { return p + t * t * v; }},
             {"half of the way is gone", [](vec3 p, vec3 v, double t) { return p + 0.5 * t * v; }},
             {"twice the way is gone", [](vec3 p, vec3 v, double t) { return p + 2.0 * t * v; }}}});
    return probe_check("points", inputs, {right});
}

/// Something that flies by, at one instant: the shutter is open so shortly that any time is the same.
struct Flight {
    Place place;
    double time;
    vec2 step;   // [pixel/s], y up
    vec2 start;  // [pixel], at time 0

    vec3 at_start() const { return film_pixel * vec3(start.x, start.y, 0); }
    vec3 velocity() const { return place.turned(film_pixel * vec3(step.x, step.y, 0)); }
    std::string instant() const { return shutter(time, time + 1e-9); }
};

/// sign  of the time
Flight any_flight(Generator& random, double sign) {
    const Place place = any_place(random);
    const double time = sign * between(random, 0.4, 0.7), turn = between(random, 0, 2 * rt::pi);
    const vec2 step = 16.0 * vec2(std::cos(turn), std::sin(turn));
    return {place, time, step, vec2(between(random, -3, 3), between(random, -3, 3)) - time * step};
}

/// Where something is in the picture, along its motion and across, from where it must be.
Check place_check(const std::string& name, const std::string& id, const std::string& thing, const std::string& scene,
                  const Flight& flight, std::function<vec2(const rt::Image&)> centroid) {
    const vec2 due = flight.start + flight.time * flight.step, seen_at(16 + due.x, 16 - due.y);
    const vec2 step(flight.step.x, -flight.step.y);
    const double speed = std::hypot(step.x, step.y), time = flight.time;
    const vec2 along = step / speed, across(-along.y, along.x);
    const auto off = [&](const std::string& what, vec2 axis, Hint hint) {
        return of_picture({.id = id,
                           .what = thing + ": distance " + what + " [pixel]",
                           .number =
                               [=](const rt::Image& image) {
                                   const vec2 d = centroid(image) - seen_at;
                                   return d.x * axis.x + d.y * axis.y;
                               },
                           .truth = 0,
                           .delta = 0.5,
                           .hint = std::move(hint)});
    };
    return render_check(name, {scene, 16, "sobol"},
                        {off("along its way from where it must be", along,
                             by_value(thing + ": its distance along its way from where it must be",
                                      {{-speed * time, "it stands still"},
                                       {-2 * speed * time, "it moves backwards"},
                                       {speed * (1 - time), "it is always where it is after 1 s"}},
                                      0.8)),
                         off("from its way", across, always(thing + " has left its way: point + time x velocity"))});
}

vec2 centroid_of_light(const rt::Image& image) { return blob_of(image).centroid; }

vec2 centroid_of_darkness(const rt::Image& image) {
    rt::Image darkness = image;
    double lit = 0;
    for (const rt::Color& p : image.pixels) lit = std::max(lit, p.r);
    for (rt::Color& p : darkness.pixels) p = rt::Color(lit - p.r);
    return blob_of(darkness).centroid;
}

Check moving_lamp(Generator& random) {
    const Flight flight = any_flight(random, -1);
    const std::string scene = toml(film_view(flight.place, {32, 32})) + flight.instant() + unsampled_lamp("lamp", 2) +
                              sphere("lamp", flight.place(flight.at_start()), 4 * film_pixel, flight.velocity());
    return place_check("lamp", "M1", "a lamp that flies by", scene, flight, centroid_of_light);
}

/// The shadow that a disc behind the camera throws on the floor below.
Check shadow(Generator& random) {
    const Flight flight = any_flight(random, 1);
    const Place& place = flight.place;
    const double x = between(random, -0.3, 0.3), y = between(random, -0.3, 0.3);
    const vec3 toward(x, y, 1);
    const std::string scene =
        toml(film_view(place, {32, 32})) + flight.instant() + material("floor", {{"albedo", 0.8}}) +
        material("card", {}) + directional_light(place.turned(toward), 3) + place.floor("floor", 1) +
        // as high as the light's slope needs; behind the camera, which does not see it
        disc("card", place(flight.at_start() + 6.0 * toward), place.axes.z, 5 * film_pixel, flight.velocity());
    return place_check("shadow", "M3", "the shadow of a card that flies by", scene, flight, centroid_of_darkness);
}

/// A lamp that flies by behind the camera, which sees it in a mirror.
Check reflection(Generator& random) {
    const Flight flight = any_flight(random, -1);
    const Place& place = flight.place;
    constexpr double eye = 3, height = 5;  // [m] of camera and lamp before the mirror, behind which the image is
    const View view = place.from_above(eye, vfov_of(16 * film_pixel, eye + height), {32, 32});
    const std::string scene =
        toml(view) + flight.instant() + unsampled_lamp("lamp", 2) + material("mirror", {{"reflectance", 1}}) +
        place.floor("mirror", 1) +
        sphere("lamp", place(flight.at_start() + vec3(0, 0, height)), 4 * film_pixel, flight.velocity());
    return place_check("reflection", "M3", "the mirror image of a lamp that flies by", scene, flight,
                       centroid_of_light);
}

}  // namespace

Checks check_moved(Generator& random) { return {points(), moving_lamp(random), shadow(random), reflection(random)}; }

}  // namespace grade
