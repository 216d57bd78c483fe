#include "asked/direct_light.h"
#include "asked/point_irradiance.h"
#include "stress/exact.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Color, rt::LightSample, rt::Material, rt::PointLight, rt::vec3;

/// The greatest relative error of a colour's channels.
double relative(Color got, const Exact& truth) {
    double worst = 0;
    for (int k = 0; k < 3; ++k) worst = worse_error(worst, apart(truth, got[k]) / double(abs(truth)));
    return worst;
}

/// Point light and surface at a distance of about x; the intensity grows with its square.
double light_distance(double x, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const vec3 n = direction(draw), p = x * box(draw, -1, 1), to = tilted(draw, n, between(draw, 0, 1.3));
        return row(PointLight{p + x * between(draw, 1, 3) * to, Color(x * x)}, p, n);
    })(random);
    return worst_of<rt::point_irradiance>(
        ask, "point_irradiance", rows, [](Color got, const PointLight& light, vec3 p, vec3 n) {
            const Exact3 way = Exact3(light.position) - Exact3(p);
            return relative(got, Exact(light.intensity.x) * dot(way, Exact3(n)) / (dot(way, way) * length(way)));
        });
}

/// n, the direction to the light, and the viewer at an angle from the mirrored one.
struct Sight {
    vec3 n, to_light, to_viewer;
};

Sight sight(Generator& random, double angle) {
    const vec3 n = direction(random), d = tilted(random, n, between(random, 0, 1.2));
    return {n, d, tilted(random, rt::unit(2 * dot(n, d) * n - d), angle)};
}

Row call_of(bool direct, const Material& m, Color light, const Sight& s) {
    if (direct) return row(m, light, LightSample{s.to_light, 1, 1}, s.n, s.to_viewer);
    return row(m, Color(0), light, s.n, s.to_light, s.to_viewer);
}

/// A highlight of exponent x, where it is between half and all of its height.
auto exponent(bool direct) {
    return [=](double x, Generator& random, const Asker& ask) {
        Material m;
        m.specular = Color(1), m.shininess = x;
        Rows rows;
        std::vector<Exact> truths;
        for (int i = 0; i < 200; ++i) {
            const Sight s = sight(random, i % 10 == 0 ? 0 : std::sqrt(between(random, 0, 1.4) / x));
            rows.push_back(call_of(direct, m, Color(1), s));
            const Exact3 n = unit(Exact3(s.n)), d = unit(Exact3(s.to_light)), c = unit(Exact3(s.to_viewer));
            truths.push_back(pow(dot(2 * dot(n, d) * n - d, c), Exact(x)));
        }
        return worst_of_rows(ask, direct ? "direct_light" : "phong", rows,
                             [&](std::size_t i, const Row& out) { return relative(from_row<Color>(out), truths[i]); });
    };
}

/// A sample of a light with density x.
double density_of_light(double x, Generator& random, const Asker& ask) {
    Material m;
    m.albedo = Color(0.5);
    const Rows rows = rows_of(60, [=](Generator& draw) {
        const Sight s = sight(draw, 0.3);
        return row(m, Color(1), LightSample{s.to_light, 1, x}, s.n, s.to_viewer);
    })(random);
    return worst_of<rt::direct_light>(
        ask, "direct_light", rows, [](Color got, const Material&, Color, const LightSample& s, vec3 n, vec3) {
            return relative(got, Exact(0.5) / rt::pi * dot(Exact3(n), Exact3(s.direction)) / s.density);
        });
}

/// Light x times as strong gives x times as much; against what light 1 gives.
auto intensity(const std::string& fragment) {
    return [=](double x, Generator& random, const Asker& ask) {
        Material m;
        m.albedo = Color(0.5), m.specular = Color(0.2), m.shininess = 8;
        Rows one, many;
        for (int i = 0; i < 60; ++i) {
            const Sight s = sight(random, 0.3);
            for (Rows* rows : {&one, &many}) {
                const Color light(rows == &one ? 1 : x);
                if (fragment == "point_irradiance")
                    rows->push_back(row(PointLight{2.0 * s.to_light, light}, vec3(0), s.n));
                else
                    rows->push_back(call_of(fragment == "direct_light", m, light, s));
            }
        }
        const Rows base = ask.probe(fragment, one);
        return worst_of_rows(ask, fragment, many, [&](std::size_t i, const Row& out) {
            return relative(from_row<Color>(out), Exact(base[i].at(0)) * x);
        });
    };
}

}  // namespace

std::vector<Family> shading_families() {
    constexpr double u = rt::roundoff;
    const std::vector<int> wide = sweep(-60, 60, 3);
    return {Family("light_distance", {"point_irradiance"}, "distance of a point light [m]", "relative error",
                   {.bound = 32 * u, .decades = wide}, light_distance),
            Family("light_intensity", {"point_irradiance"}, "intensity of a point light", "relative error",
                   {.bound = 16 * u, .decades = wide}, intensity("point_irradiance")),
            Family("phong_exponent", {"phong"}, "exponent of a highlight", "relative error",
                   {.tolerance = 2e-2, .bound = 1e-10, .decades = sweep(0, 14), .scored = {0, 4}}, exponent(false)),
            Family("phong_intensity", {"phong"}, "irradiance", "relative error", {.bound = 16 * u, .decades = wide},
                   intensity("phong")),
            Family("direct_exponent", {"direct_light"}, "exponent of a highlight", "relative error",
                   {.tolerance = 2e-2, .bound = 1e-10, .decades = sweep(0, 14), .scored = {0, 4}}, exponent(true)),
            Family("direct_density", {"direct_light"}, "density of a light's sample [1/sr]", "relative error",
                   {.bound = 32 * u, .decades = wide}, density_of_light),
            Family("direct_intensity", {"direct_light"}, "radiance of a light", "relative error",
                   {.bound = 16 * u, .decades = wide}, intensity("direct_light"))};
}

}  // namespace grade::stress
