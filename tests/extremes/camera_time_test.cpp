/// Lenses, fields of view, shutters: extremes.md 58 to 60, 62.

#include "extremes/extremes.h"
#include "rt/files/scene_reader.h"
#include "rt/fragments.h"
#include "rt/sampler.h"

using namespace rt;

TEST_CASE("58 59 focus from 1e-9 to 1e12 and infinitely far: the ray meets the pinhole's ray in that plane",
          "[extremes]") {
    Random random(59);
    Greatest missed, bent, still;
    for (int k = 0; k < 100000; ++k) {
        const Frame frame = frame_about(random.direction());
        Camera camera;
        camera.eye = vec3(0);
        camera.right = frame.x, camera.up = frame.y, camera.back = frame.z;
        camera.focus = random.scale(1e-9, 1e12);
        camera.lens_radius = random.scale(1e-9, 1e3);
        const Ray pinhole = camera_ray(camera, 256.0 * random.point());
        const vec2 u = random.point();
        const Ray ray = lens_ray(camera, pinhole, u);
        const Real t = camera.focus / -dot(pinhole.direction, camera.back);
        const Long target = (long double)(t)*Long(pinhole.direction), o = Long(ray.origin), d = Long(ray.direction);
        const Long to = target - o;
        const long double apart = exact_length(to - exact_dot(to, d) / exact_dot(d, d) * d);
        missed.see(double(apart / (exact_length(to) + exact_length(o))) / roundoff);

        camera.focus = inf;
        bent.see(largest(lens_ray(camera, pinhole, u).direction - pinhole.direction) / roundoff);
        camera.lens_radius = 0;
        camera.focus = 1;
        still.see(largest(lens_ray(camera, pinhole, u).direction - pinhole.direction) / roundoff);
        CHECK(lens_ray(camera, pinhole, u).origin == pinhole.origin);
    }
    figure(59, "distance of the ray from the focus point, relative, in u", missed.value, 8);
    figure(59, "focus at infinity: bend, in u", bent.value, 4);
    figure(58, "lens_ray with aperture 0: bend, in u (the plan leaves it out: bitwise)", still.value, 4);
}

TEST_CASE("60 fields of view from 1e-6 to 179.9999 degrees", "[extremes]") {
    Greatest off;
    for (const Real degrees : {1e-6, 1e-3, 1.0, 90.0, 179.0, 179.99, 179.9999}) {
        const Scene scene =
            parse_scene("[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\nvfov = " + std::to_string(degrees), "s.toml");
        const Camera& camera = scene.camera;
        for (int y = 0; y <= camera.size.y; y += 16) {
            const Ray ray = camera_ray(camera, {0.5 * camera.size.x, Real(y)});
            CHECK(std::isfinite(dot(ray.direction, ray.direction)));
            // The tangent of the angle goes linearly with the film.
            const Real due = camera.tan_half_fov * (1 - 2.0 * y / camera.size.y),
                       is = ray.direction.y / -ray.direction.z;
            if (due != 0) off.see(std::abs(is / due - 1) / roundoff);
        }
    }
    figure(60, "tangent of the angle to the axis, relative, in u", off.value, 16);
}

TEST_CASE("59 60 a focus of 0, fields of view of 0 and 180 degrees are rejected where they stand", "[extremes]") {
    const std::string camera = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n";
    const auto complaint = [&](const std::string& line) {
        return complaint_of([&] { parse_scene(camera + line, "s.toml"); });
    };
    CHECK(complaint("focus = 0").rfind("s.toml:4:9: 'focus' is 0; expected ", 0) == 0);
    CHECK(complaint("focus = -1").rfind("s.toml:4:9: 'focus' is -1; expected ", 0) == 0);
    CHECK(complaint("vfov = 0").rfind("s.toml:4:8: 'vfov' is 0; expected ", 0) == 0);
    CHECK(complaint("vfov = 180").rfind("s.toml:4:8: 'vfov' is 180; expected ", 0) == 0);
    CHECK(complaint("vfov = 179.9999") == "");
    CHECK(complaint("vfov = 1e-6") == "");
    CHECK(complaint("focus = 1e-9") == "");
    CHECK(complaint("focus = inf") == "");
}

TEST_CASE("62 a ball that crosses at 1e6 m/s blocks the view for 2e-6 s, to 2/N", "[extremes]") {
    const int n = 10000000;
    const Shutter shutter{0, 1};
    for (const Bits key : {Bits(1), Bits(2)}) {
        std::int64_t blocked = 0;
        for (int i = 0; i < n; ++i) {
            const Real time = shutter_time(shutter, pattern_1d<Sampler::stratified>(key, i, n, 2));
            const Sphere ball{moved({-5e5, 0, -10}, {1e6, 0, 0}, time), 1};
            blocked += hit_sphere(ball, {vec3(0), {0, 0, -1}, 0, inf}) < inf;
        }
        figure(62, "time for which the ball blocks the view, off by, in 1/N", std::abs(Real(blocked) - 2e-6 * n), 2);
    }
}
