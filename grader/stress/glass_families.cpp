#include "asked/fresnel_dielectric.h"
#include "asked/mirror_direction.h"
#include "asked/refracted_direction.h"
#include "asked/whitted.h"
#include "stress/exact.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Color, rt::Material, rt::Outgoing, rt::vec3;

/// The direction by Snell's law; the zero vector at total internal reflection.
Exact3 refracted(vec3 d, vec3 n, double from, double to) {
    const Exact3 way = unit(Exact3(d)), normal = unit(Exact3(n));
    const Exact ratio = Exact(from) / to, cosine = -dot(way, normal),
                squared = 1 - ratio * ratio * (1 - cosine * cosine);
    if (squared < 0) return {0, 0, 0};
    return ratio * way + (ratio * cosine - sqrt(squared)) * normal;
}

Exact reflectance(double cosine, double from, double to) {
    const Exact e1 = from, e2 = to, c1 = cosine, cosine2 = 1 - e1 * e1 / (e2 * e2) * (1 - c1 * c1);
    if (cosine2 < 0) return 1;
    if (from == to) return 0;
    const Exact c2 = sqrt(cosine2), s = (e1 * c1 - e2 * c2) / (e1 * c1 + e2 * c2),
                p = (e2 * c1 - e1 * c2) / (e2 * c1 + e1 * c2);
    return s * s / 2 + p * p / 2;
}

/// Errors of refracted_direction, times a factor that takes out how ill-conditioned the case is; draw(random) is a row.
template <class Draw>
double error_of_bends(double factor, Generator& random, const Asker& ask, Draw draw) {
    const auto error = [=](vec3 got, vec3 d, vec3 n, double from, double to) {
        const Exact3 truth = refracted(d, n, from, to);
        const bool total = truth.x == 0 && truth.y == 0 && truth.z == 0;
        if (total != (got == vec3(0))) return rt::inf;
        return total ? 0 : apart(truth, got) * factor;
    };
    return worst_of<rt::refracted_direction>(ask, "refracted_direction", rows_of(200, draw)(random), error);
}

/// A sine that is the share x below or above that of the critical angle.
double near_critical(Generator& random, double x, double from, double to) {
    return to / from * (chance(random, 0.7) ? 1 - x : 1 + x);
}

double refracted_critical(double x, Generator& random, const Asker& ask) {
    return error_of_bends(std::sqrt(x), random, ask, [=](Generator& draw) {
        const vec3 n = direction(draw);
        const double from = between(draw, 1.3, 2.4);
        return row(-tilted(draw, n, std::asin(near_critical(draw, x, from, 1))), n, from, 1.0);
    });
}

double refracted_grazing(double x, Generator& random, const Asker& ask) {
    return error_of_bends(1, random, ask, [=](Generator& draw) {
        const vec3 n = direction(draw), d = rt::unit(tilted(draw, n, rt::pi / 2) - x * n);
        return row(d, n, 1.0, between(draw, 1.2, 2.4));
    });
}

double refracted_normal(double x, Generator& random, const Asker& ask) {
    int i = 0;
    return error_of_bends(1, random, ask, [&, x](Generator& draw) {
        const vec3 n = direction(draw), d = i++ < 20 && x < 1e-3 ? -n : -tilted(draw, n, x);
        const double from = between(draw, 1, 1.5), to = between(draw, 1, 1.5);
        return row(d, n, from, to);
    });
}

double refracted_even(double x, Generator& random, const Asker& ask) {
    return error_of_bends(1, random, ask, [=](Generator& draw) {
        const vec3 n = direction(draw), d = -tilted(draw, n, between(draw, 0, 1.1));
        return row(d, n, 1.0, chance(draw, 0.5) ? 1 + x : 1 - x);
    });
}

double error_of_reflectance(const Rows& rows, double factor, const Asker& ask) {
    return worst_of<rt::fresnel_dielectric>(
        ask, "fresnel_dielectric", rows, [=](double got, double cosine, double from, double to) {
            return got < 0 ? rt::inf : apart(reflectance(cosine, from, to), got) * factor;
        });
}

double fresnel_critical(double x, Generator& random, const Asker& ask) {
    const auto boundary = [=](Generator& draw) {
        const double from = between(draw, 1.3, 2.4), sine = near_critical(draw, x, from, 1);
        return row(std::sqrt((1 - sine) * (1 + sine)), from, 1.0);
    };
    return error_of_reflectance(rows_of(200, boundary)(random), std::sqrt(x), ask);
}

double fresnel_grazing(double x, Generator& random, const Asker& ask) {
    const auto boundary = [=](Generator& draw) {
        const double cosine = x * between(draw, 0.5, 1);
        return row(cosine, 1.0, between(draw, 1.2, 2.4));
    };
    return error_of_reflectance(rows_of(200, boundary)(random), 1, ask);
}

/// Indices that differ by x, and beyond ordinary scenes also rays along the surface.
double fresnel_even(double x, Generator& random, const Asker& ask) {
    Rows rows = rows_of(200, [=](Generator& draw) {
        const double cosine = between(draw, 0.3, 1);
        return row(cosine, 1.0, chance(draw, 0.5) ? 1 + x : 1 - x);
    })(random);
    for (const double other : {1.0, 1.5, 1 + x}) rows.push_back(row(1.0, 1.0, other));
    if (x < 1e-3)
        for (const double even : {1.0, 1.5})
            rows.push_back(row(0.0, even, even)), rows.push_back(row(1e-200, even, even));
    return error_of_reflectance(rows, 1, ask);
}

double mirror_length(double x, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const vec3 d = x * direction(draw);
        return row(d, direction(draw));
    })(random);
    return worst_of<rt::mirror_direction>(ask, "mirror_direction", rows, [=](vec3 got, vec3 from, vec3 normal) {
        const Exact3 d(from), n(normal);
        return apart(d - 2 * dot(d, n) * n, got) / x;
    });
}

/// Glass and mirrors that let so little through.
double faint(double x, Generator& random, const Asker& ask) {
    Rows rows;
    for (int i = 0; i < 30; ++i) {
        Material m;
        m.reflectance = Color(chance(random, 0.5) ? x : 1), m.transmittance = Color(x, i % 2 ? 0 : x, 0);
        rows.push_back(row(m, between(random, 0, 1)));
    }
    return worst_of<rt::whitted>(ask, "whitted", rows, [](const Outgoing& got, const Material& m, double fresnel) {
        const Color mirror = fresnel * m.reflectance, glass = (1 - fresnel) * m.transmittance;
        return worse_error(rt::largest(got.mirror - mirror) / rt::largest(mirror),
                           rt::largest(got.glass - glass) / rt::largest(glass));
    });
}

}  // namespace

std::vector<Family> glass_families() {
    constexpr double u = rt::roundoff;
    return {
        Family("mirror_length", {"mirror_direction"}, "length of the direction", "error / length",
               {.bound = 16 * u, .decades = sweep(-60, 60, 3)}, mirror_length),
        Family("refracted_critical", {"refracted_direction"}, "distance from the critical angle", "error x root of x",
               {.bound = 32 * u, .decades = sweep(-13, -1), .scored = {-3, -1}}, refracted_critical),
        Family("refracted_grazing", {"refracted_direction"}, "cosine of the incoming ray", "error",
               {.bound = 16 * u, .decades = sweep(-15, -1), .scored = {-3, -1}}, refracted_grazing),
        Family("refracted_normal", {"refracted_direction"}, "angle between ray and normal", "error",
               {.bound = 16 * u, .decades = sweep(-16, -1), .scored = {-3, -1}}, refracted_normal),
        Family("refracted_even", {"refracted_direction"}, "difference of the indices", "error",
               {.bound = 16 * u, .decades = sweep(-17, -1), .scored = {-3, -1}}, refracted_even),
        Family("fresnel_critical", {"fresnel_dielectric"}, "distance from the critical angle", "error x root of x",
               {.bound = 64 * u, .decades = sweep(-13, -1), .scored = {-3, -1}}, fresnel_critical),
        Family("fresnel_grazing", {"fresnel_dielectric"}, "cosine of the incoming ray", "error",
               {.bound = 16 * u, .decades = sweep(-15, -1), .scored = {-3, -1}}, fresnel_grazing),
        Family("fresnel_even", {"fresnel_dielectric"}, "difference of the indices", "error",
               {.bound = 16 * u, .decades = sweep(-17, -1), .scored = {-3, -1}}, fresnel_even),
        Family("whitted_faint", {"whitted"}, "transmittance", "relative error",
               {.bound = 8 * u, .decades = sweep(-60, 0, 3), .scored = {-3, 0}}, faint)};
}

}  // namespace grade::stress
