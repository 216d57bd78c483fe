#include "catch.h"
#include "random.h"
#include "rt/fragments.h"
#include "warp.h"

using namespace rt;

namespace {

Camera random_camera(Random& random) {
    const Frame frame = frame_about(random.direction());
    Camera camera;
    camera.eye = random.in_cube();
    camera.right = frame.x, camera.up = frame.y, camera.back = frame.z;
    camera.lens_radius = random.scale(1e-3, 1);
    camera.focus = random.scale(0.1, 1000);
    return camera;
}

}  // namespace

TEST_CASE(
    "film_sample: the samples of a pixel cover it, have its centre as mean and 1/12 of its size squared as variance") {
    Random random(1);
    for (const int n : {1, 2, 5, 16, 37}) {
        const Extent pixel{{12, 7}, {12.5, 9}};
        const vec2 size = pixel.high - pixel.low, center = 0.5 * (pixel.low + pixel.high);
        const int rounds = 200000 / n;
        vec2 mean(0), square(0);
        Real weight = 0;
        for (int k = 0; k < rounds; ++k)
            for (int i = 0; i < n; ++i) {
                const FilmSample sample = film_sample(pixel, i, n, random.point());
                const vec2 p = (sample.position - center) / size;
                if (!(std::abs(p.x) <= 0.5 && std::abs(p.y) <= 0.5))
                    FAIL("sample outside the pixel: " << text(sample.position));
                mean += sample.weight * p / (Real(rounds) * n);
                square += sample.weight * p * p / (Real(rounds) * n);
                weight += sample.weight / (Real(rounds) * n);
            }
        INFO("n " << n << ", mean " << text(mean) << ", variance " << text(square));
        CHECK((std::abs(mean.x) < 0.004 && std::abs(mean.y) < 0.004));
        CHECK(square.x == Approx(1.0 / 12).epsilon(0.01));
        CHECK(square.y == Approx(1.0 / 12).epsilon(0.01));
        CHECK(weight == Approx(1).epsilon(1e-9));
    }
}

TEST_CASE("pixel_mean: weighted mean, linear, without clamp, and without loss over many samples") {
    const std::vector<Color> radiance = {{1, 0, 1e6}, {3, 0, 0}};
    const Color mean = pixel_mean(radiance, std::vector<Real>{1, 1});
    CHECK((mean.x == 2 && mean.y == 0 && mean.z == 5e5));
    CHECK(pixel_mean(radiance, std::vector<Real>{0.5, 1.5}).x == Approx(2.5));
    const std::vector<Color> dim(1000000, Color(0.1));
    CHECK(pixel_mean(dim, std::vector<Real>(dim.size(), 1)).y == Approx(0.1).epsilon(1e-15));
}

TEST_CASE("lens_ray: through the point in focus, from a point of the lens") {
    Random random(2);
    for (int i = 0; i < 3000; ++i) {
        const Camera camera = random_camera(random);
        const Ray pinhole{camera.eye, -random.direction_about(camera.back, 0.2), 0, inf};
        const Ray ray = lens_ray(camera, pinhole, random.point());
        INFO("focus " << camera.focus << ", lens radius " << camera.lens_radius << ", pinhole's direction "
                      << text(pinhole.direction));
        const vec3 offset = ray.origin - camera.eye;
        CHECK(std::sqrt(dot(offset, offset)) <= camera.lens_radius * (1 + 1e-9));
        CHECK(dot(offset, camera.back) == Approx(0).margin(1e-12));
        CHECK(dot(ray.direction, ray.direction) == Approx(1).epsilon(1e-12));
        CHECK((ray.near == 0 && ray.far == inf));

        const vec3 in_focus = camera.eye + camera.focus / -dot(pinhole.direction, camera.back) * pinhole.direction;
        const vec3 miss = cross(in_focus - ray.origin, ray.direction);
        CHECK(std::sqrt(dot(miss, miss)) < 1e-12 * (camera.focus * 5 + 1));
        CHECK(dot(in_focus - ray.origin, ray.direction) > 0);
    }
}

TEST_CASE(
    "lens_ray: all parts of the lens get their share; no lens is a pinhole; focus at infinity gives parallel rays") {
    Random random(3);
    Camera camera = random_camera(random);
    const Ray pinhole{camera.eye, -random.direction_about(camera.back, 0.2), 0, inf};
    const Real p = uniform_probability([&] {
        const vec3 offset = (lens_ray(camera, pinhole, random.point()).origin - camera.eye) / camera.lens_radius;
        const Real x = dot(offset, camera.right), y = dot(offset, camera.up);
        return vec2(x * x + y * y, turn(x, y));
    });
    CHECK(p > 1e-4);

    camera.focus = inf;
    CHECK(dot(lens_ray(camera, pinhole, random.point()).direction, pinhole.direction) == Approx(1).epsilon(1e-14));
    camera.focus = 3;
    camera.lens_radius = 0;
    const Ray sharp = lens_ray(camera, pinhole, random.point());
    CHECK(sharp.origin == pinhole.origin);
    CHECK(dot(sharp.direction, pinhole.direction) == Approx(1).epsilon(1e-14));
}

TEST_CASE("shutter_time: uniform between opening and closing, both ends included where nothing lies between") {
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        Shutter shutter;
        shutter.open = random.between(-5, 5);
        shutter.close = shutter.open + random.scale(1e-6, 10);
        INFO("shutter " << shutter.open << " to " << shutter.close);
        Real mean = 0, square = 0;
        for (int k = 0; k < 1000; ++k) {
            const Real time = shutter_time(shutter, (k + 0.5) / 1000);
            CHECK((time >= shutter.open && time <= shutter.close));
            const Real share = (time - shutter.open) / (shutter.close - shutter.open);
            mean += share / 1000, square += share * share / 1000;
        }
        CHECK(mean == Approx(0.5).epsilon(1e-6));
        CHECK(square - mean * mean == Approx(1.0 / 12).epsilon(1e-5));
    }
    CHECK(shutter_time({2, 2}, 0.7) == 2);
}

TEST_CASE("moved: nowhere at time 0, in steps as at once, backwards too") {
    Random random(5);
    for (int i = 0; i < 200; ++i) {
        const vec3 point = random.in_cube(), velocity = random.in_cube();
        const Real s = random.between(-3, 3), t = random.between(-3, 3);
        INFO("point " << text(point) << ", velocity " << text(velocity) << ", times " << s << " " << t);
        CHECK(moved(point, velocity, 0) == point);
        const vec3 gap = moved(moved(point, velocity, s), velocity, t) - moved(point, velocity, s + t);
        CHECK(largest(gap) < 1e-14);
        CHECK(largest(moved(point, velocity, 1) - point - velocity) < 1e-15);
    }
}

TEST_CASE("emission_counts: always, but where a diffuse surface has sampled the light already") {
    for (const Event previous : {Event::camera, Event::diffuse, Event::specular, Event::lobe, Event::medium}) {
        INFO("event " << int(previous));
        CHECK(emission_counts(previous, false));
        CHECK(emission_counts(previous, true) == (previous != Event::diffuse));
    }
}

TEST_CASE("free_flight: mean 1/s; the share that gets further than t is exp(-s t); finite for the greatest u") {
    for (const Real extinction : {1e-6, 0.1, 1.0, 37.0, 1e6}) {
        INFO("extinction " << extinction);
        Real mean = 0;
        for (int k = 0; k < 200000; ++k) mean += free_flight(extinction, (k + 0.5) / 200000) / 200000;
        CHECK(mean * extinction == Approx(1).epsilon(1e-4));
        int further = 0;
        for (int k = 0; k < 10000; ++k) further += free_flight(extinction, (k + 0.5) / 10000) > 0.7 / extinction;
        CHECK(further / 10000.0 == Approx(std::exp(-0.7)).margin(1e-3));
        CHECK(free_flight(extinction, 0) >= 0);
        CHECK(free_flight(extinction, 1 - 0x1p-53) < inf);
        CHECK(free_flight(extinction, 0x1p-60) * extinction == Approx(0x1p-60).epsilon(1e-12));  // no digits lost
    }
}
