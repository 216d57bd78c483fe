#include "stress/exact.h"
#include "stress/family.h"

namespace grade {

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
    if (cosine2 < 0) return Exact(1);
    if (from == to) return 0;
    const Exact c2 = sqrt(cosine2), s = (e1 * c1 - e2 * c2) / (e1 * c1 + e2 * c2),
                p = (e2 * c1 - e1 * c2) / (e2 * c1 + e1 * c2);
    return s * s / 2 + p * p / 2;
}

/// Errors of refracted_direction, times a factor that takes out how ill-conditioned the case is.
struct Bend {
    vec3 d, n;
    double from, to;
};

double error_of_bends(const std::vector<Bend>& bends, double factor, const Asker& ask) {
    Rows rows;
    for (const Bend& b : bends) rows.push_back(row(b.d, b.n, b.from, b.to));
    return worst_of(ask, "refracted_direction", rows, [&](std::size_t i, const Row& out) {
        const Exact3 truth = refracted(bends[i].d, bends[i].n, bends[i].from, bends[i].to);
        const vec3 got = from_row<vec3>(out);
        const bool total = truth.x == 0 && truth.y == 0 && truth.z == 0;
        if (total != (got == vec3(0))) return rt::inf;
        return total ? 0 : apart(truth, got) * factor;
    });
}

/// A sine that is the share x below or above that of the critical angle.
double near_critical(Generator& random, double x, double from, double to) {
    return to / from * (chance(random, 0.7) ? 1 - x : 1 + x);
}

double refracted_critical(double x, Generator& random, const Asker& ask) {
    std::vector<Bend> bends;
    for (int i = 0; i < 200; ++i) {
        const vec3 n = direction(random);
        const double from = between(random, 1.3, 2.4);
        bends.push_back({-tilted(random, n, std::asin(near_critical(random, x, from, 1))), n, from, 1});
    }
    return error_of_bends(bends, std::sqrt(x), ask);
}

double refracted_grazing(double x, Generator& random, const Asker& ask) {
    std::vector<Bend> bends;
    for (int i = 0; i < 200; ++i) {
        const vec3 n = direction(random);
        bends.push_back({rt::unit(tilted(random, n, rt::pi / 2) - x * n), n, 1, between(random, 1.2, 2.4)});
    }
    return error_of_bends(bends, 1, ask);
}

double refracted_normal(double x, Generator& random, const Asker& ask) {
    std::vector<Bend> bends;
    for (int i = 0; i < 200; ++i) {
        const vec3 n = direction(random);
        bends.push_back(
            {i < 20 && x < 1e-3 ? -n : -tilted(random, n, x), n, between(random, 1, 1.5), between(random, 1, 1.5)});
    }
    return error_of_bends(bends, 1, ask);
}

double refracted_even(double x, Generator& random, const Asker& ask) {
    std::vector<Bend> bends;
    for (int i = 0; i < 200; ++i) {
        const vec3 n = direction(random);
        bends.push_back({-tilted(random, n, between(random, 0, 1.1)), n, 1, chance(random, 0.5) ? 1 + x : 1 - x});
    }
    return error_of_bends(bends, 1, ask);
}

struct Boundary {
    double cosine, from, to;
};

double error_of_boundaries(const std::vector<Boundary>& boundaries, double factor, const Asker& ask) {
    Rows rows;
    for (const Boundary& b : boundaries) rows.push_back(row(b.cosine, b.from, b.to));
    return worst_of(ask, "fresnel_dielectric", rows, [&](std::size_t i, const Row& out) {
        const auto [cosine, from, to] = boundaries[i];
        return out.at(0) < 0 ? rt::inf : apart(reflectance(cosine, from, to), out[0]) * factor;
    });
}

double fresnel_critical(double x, Generator& random, const Asker& ask) {
    std::vector<Boundary> boundaries;
    for (int i = 0; i < 200; ++i) {
        const double from = between(random, 1.3, 2.4), sine = near_critical(random, x, from, 1);
        boundaries.push_back({std::sqrt((1 - sine) * (1 + sine)), from, 1});
    }
    return error_of_boundaries(boundaries, std::sqrt(x), ask);
}

double fresnel_grazing(double x, Generator& random, const Asker& ask) {
    std::vector<Boundary> boundaries;
    for (int i = 0; i < 200; ++i) boundaries.push_back({x * between(random, 0.5, 1), 1, between(random, 1.2, 2.4)});
    return error_of_boundaries(boundaries, 1, ask);
}

/// Indices that differ by x, and beyond ordinary scenes also rays along the surface.
double fresnel_even(double x, Generator& random, const Asker& ask) {
    std::vector<Boundary> boundaries;
    for (int i = 0; i < 200; ++i)
        boundaries.push_back({between(random, 0.3, 1), 1, chance(random, 0.5) ? 1 + x : 1 - x});
    for (const double other : {1.0, 1.5, 1 + x}) boundaries.push_back({1, 1, other});
    if (x < 1e-3)
        for (const double even : {1.0, 1.5})
            boundaries.push_back({0, even, even}), boundaries.push_back({1e-200, even, even});
    return error_of_boundaries(boundaries, 1, ask);
}

double mirror_length(double x, Generator& random, const Asker& ask) {
    std::vector<std::pair<vec3, vec3>> pairs;
    Rows rows;
    for (int i = 0; i < 200; ++i) {
        pairs.push_back({x * direction(random), direction(random)});
        rows.push_back(row(pairs.back().first, pairs.back().second));
    }
    return worst_of(ask, "mirror_direction", rows, [&](std::size_t i, const Row& out) {
        const Exact3 d(pairs[i].first), n(pairs[i].second);
        return apart(d - 2 * dot(d, n) * n, from_row<vec3>(out)) / x;
    });
}

/// Glass and mirrors that let so little through.
double faint(double x, Generator& random, const Asker& ask) {
    std::vector<std::pair<Material, double>> cases;
    Rows rows;
    for (int i = 0; i < 30; ++i) {
        Material m;
        m.reflectance = Color(chance(random, 0.5) ? x : 1), m.transmittance = Color(x, i % 2 ? 0 : x, 0);
        cases.push_back({m, between(random, 0, 1)});
        rows.push_back(row(m, cases.back().second));
    }
    return worst_of(ask, "whitted", rows, [&](std::size_t i, const Row& out) {
        const auto& [m, fresnel] = cases[i];
        const Outgoing got = from_row<Outgoing>(out);
        const Color mirror = fresnel * m.reflectance, glass = (1 - fresnel) * m.transmittance;
        return worse_error(rt::largest(got.mirror - mirror) / rt::largest(mirror),
                           rt::largest(got.glass - glass) / rt::largest(glass));
    });
}

}  // namespace

std::vector<Family> glass_families() {
    constexpr double u = rt::roundoff;
    return {
        {"mirror_length",
         {"mirror_direction"},
         "length of the direction",
         "error / length",
         1e-5,
         16 * u,
         sweep(-60, 60, 3),
         {-3, 3},
         mirror_length},
        {"refracted_critical",
         {"refracted_direction"},
         "distance from the critical angle",
         "error x root of x",
         1e-5,
         32 * u,
         sweep(-13, -1),
         {-3, -1},
         refracted_critical},
        {"refracted_grazing",
         {"refracted_direction"},
         "cosine of the incoming ray",
         "error",
         1e-5,
         16 * u,
         sweep(-15, -1),
         {-3, -1},
         refracted_grazing},
        {"refracted_normal",
         {"refracted_direction"},
         "angle between ray and normal",
         "error",
         1e-5,
         16 * u,
         sweep(-16, -1),
         {-3, -1},
         refracted_normal},
        {"refracted_even",
         {"refracted_direction"},
         "difference of the indices",
         "error",
         1e-5,
         16 * u,
         sweep(-17, -1),
         {-3, -1},
         refracted_even},
        {"fresnel_critical",
         {"fresnel_dielectric"},
         "distance from the critical angle",
         "error x root of x",
         1e-5,
         64 * u,
         sweep(-13, -1),
         {-3, -1},
         fresnel_critical},
        {"fresnel_grazing",
         {"fresnel_dielectric"},
         "cosine of the incoming ray",
         "error",
         1e-5,
         16 * u,
         sweep(-15, -1),
         {-3, -1},
         fresnel_grazing},
        {"fresnel_even",
         {"fresnel_dielectric"},
         "difference of the indices",
         "error",
         1e-5,
         16 * u,
         sweep(-17, -1),
         {-3, -1},
         fresnel_even},
        {"whitted_faint",
         {"whitted"},
         "transmittance",
         "relative error",
         1e-5,
         8 * u,
         sweep(-60, 0, 3),
         {-3, 0},
         faint},
    };
}

}  // namespace grade
