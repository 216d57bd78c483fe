#include <random>

#include "catch.h"
#include "statistics/closed_forms.h"
#include "statistics/moments.h"

using namespace grade;
using rt::vec3;

TEST_CASE("irradiance by a quad is the integral over its area of both cosines over r squared") {
    const rt::Quad quad{{0.3, 0.2, 1.5}, {0.4, 0, 0.1}, {0, -0.3, 0}};
    const vec3 p(0.1, -0.2, 0), n = rt::unit(vec3(0.1, 0.2, 1));
    const vec3 front = rt::unit(rt::cross(quad.u, quad.v));
    const double area = 4 * std::sqrt(rt::dot(rt::cross(quad.u, quad.v), rt::cross(quad.u, quad.v)));
    double sum = 0;
    const int grid = 400;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j < grid; ++j) {
            const vec3 q = quad.center + (2 * (i + 0.5) / grid - 1) * quad.u + (2 * (j + 0.5) / grid - 1) * quad.v;
            const vec3 d = q - p;
            const double square = rt::dot(d, d);
            sum += rt::dot(n, d) * -rt::dot(front, d) / (square * square) * area / (grid * grid);
        }
    CHECK(quad_irradiance(quad, p, n) == Approx(sum).epsilon(1e-6));
}

TEST_CASE("irradiance by a small disc, quad and sphere of one area agree far away, and a disc near by fills the sky") {
    const double r = 0.01, side = std::sqrt(rt::pi) * r / 2;
    const rt::Quad quad{{0, 0, 5}, {side, 0, 0}, {0, -side, 0}};
    CHECK(quad_irradiance(quad, vec3(0), {0, 0, 1}) == Approx(coaxial_disc_irradiance(r, 5)).epsilon(1e-5));
    CHECK(sphere_irradiance({{0, 0, 5}, r}, vec3(0), {0, 0, 1}) == Approx(coaxial_disc_irradiance(r, 5)).epsilon(1e-5));
    CHECK(coaxial_disc_irradiance(1e6, 1) == Approx(rt::pi));
    CHECK(sphere_irradiance({{3, 0, 4}, 1}, vec3(0), {0, 0, 1}) == Approx(rt::pi / 25 * 0.8));
}

TEST_CASE("moments of the lobe are those of directions drawn from it") {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> u(0, 1);
    for (double n : {3.0, 50.0}) {
        Moments estimate;
        for (int k = 0; k < 100000; ++k) {
            const double c = std::pow(u(random), 1 / (n + 1));
            estimate.add((n + 2) / (n + 1) * c);  // of the BRDF's integral, at normal incidence
        }
        CHECK(estimate.mean == Approx(phong_albedo(n, 0)).margin(4 * estimate.standard_error()));
        CHECK(estimate.variance() == Approx(lobe_dispersion(n)).epsilon(0.05));
    }
}

TEST_CASE("the albedo of the lobe falls towards grazing angles as tabulated") {
    CHECK(phong_albedo(10, 0) == Approx(1).epsilon(1e-9));
    CHECK(phong_moment(10, 0, 1) == Approx(12.0 / 13).epsilon(1e-9));
    CHECK(phong_albedo(10, rt::pi / 3) == Approx(0.505).margin(5e-4));
    CHECK(phong_albedo(10, rt::pi * 80 / 180) == Approx(0.228).margin(5e-4));
    CHECK(phong_albedo(50, rt::pi / 3) == Approx(0.500).margin(5e-4));
    CHECK(phong_albedo(50, rt::pi * 80 / 180) == Approx(0.181).margin(5e-4));
}

TEST_CASE("a furnace adds up its bounces") {
    CHECK(furnace_radiance(2, 0.5, 0) == Approx(2));
    CHECK(furnace_radiance(2, 0.5, 2) == Approx(2 * (1 + 0.5 + 0.25)));
    CHECK(furnace_radiance(2, 1, 3) == Approx(8));
}

TEST_CASE("geometry of blur, penumbra and slab") {
    rt::Camera camera;
    camera.size = {64, 64};
    camera.tan_half_fov = 0.5;
    camera.lens_radius = 0.1;
    camera.focus = 4;
    // a point at 2: the cone from the lens at focus distance has radius 0.1 (4 - 2) / 2 = 0.1, where 64 pixels take 4 m
    CHECK(blur_radius(camera, 2) == Approx(0.1 * 64 / 4));
    CHECK(blur_radius(camera, 4) == Approx(0).margin(1e-15));
    CHECK(penumbra_width(1, 4, 2) == Approx(1));
    CHECK(penumbra_width(1, 4, 1) == Approx(1.0 / 3));
    // at 45 degrees through n: exit is moved by thickness (tan t - tan t') cos t
    const double t = 0.7, inside = std::asin(std::sin(t) / 1.5);
    CHECK(slab_shift(t, 1.5) == Approx((std::tan(t) - std::tan(inside)) * std::cos(t)));
}
