#include "asked/shadow_ray.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Hit, rt::Ray, rt::vec3;

enum class Surface { sphere, quad, triangle };

/// A surface of a scene of that size, and how far its parts are from the world's origin.
struct Wall {
    Surface kind;
    rt::Sphere sphere;
    rt::Quad quad;
    rt::Triangle triangle;
    double reach;

    Row row_with(const Ray& ray) const {
        return kind == Surface::sphere ? row(sphere, ray) : kind == Surface::quad ? row(quad, ray) : row(triangle, ray);
    }
};

Wall wall(Surface kind, double size, Generator& random) {
    const vec3 center = size * box(random, -2, 2);
    const rt::Frame frame = rt::frame_about(direction(random));
    const double radius = size * log_between(random, 0.5, 2);
    const rt::Quad quad{center, radius * frame.x, radius * frame.y};
    return {kind,
            {center, radius},
            quad,
            {center - quad.u - quad.v, center + quad.u - quad.v, center + 2.0 * quad.v},
            rt::largest(vec3(std::abs(center.x), std::abs(center.y), std::abs(center.z)) + radius)};
}

vec3 normal_at(const Wall& w, vec3 p) {
    return w.kind == Surface::sphere ? rt::unit(p - w.sphere.center) : rt::unit(cross(w.quad.u, w.quad.v));
}

const char* fragment_of(Surface kind) {
    return kind == Surface::sphere ? "hit_sphere" : kind == Surface::quad ? "hit_quad" : "hit_triangle";
}

/// The share of rays which leave a surface that meet that surface. Hits, errors and rays are made as the framework
/// does.
double self_hits(Surface kind, double size, Generator& random, const Asker& ask) {
    constexpr int count = 300;
    std::vector<Wall> walls;
    std::vector<Ray> rays;
    Rows rows;
    for (int i = 0; i < count; ++i) {
        walls.push_back(wall(kind, size, random));
        const Wall& w = walls.back();
        const vec3 d = direction(random),
                   target = w.quad.center +
                            0.3 * (w.kind == Surface::sphere ? w.sphere.radius * tilted(random, d, 1) : w.quad.u);
        rays.push_back({target - between(random, 3, 6) * size * d, d, 0, rt::inf});
        rows.push_back(w.row_with(rays.back()));
    }
    const Rows hits = ask.probe(fragment_of(kind), rows);

    std::vector<std::size_t> who;
    Rows leaving;
    for (std::size_t i = 0; i < count; ++i) {
        const double t = hits[i].at(0);
        if (!std::isfinite(t)) continue;
        const Ray& ray = rays[i];
        const vec3 p = ray.origin + t * ray.direction;
        const vec3 outside = normal_at(walls[i], p), n = dot(ray.direction, outside) > 0 ? -outside : outside;
        const double error = 32 * rt::roundoff * (rt::largest(p) + walls[i].reach);
        const bool sphere = kind == Surface::sphere;
        const vec3 to = tilted(random, sphere || chance(random, 0.5) ? n : -n, std::acos(between(random, 0, 1)));
        leaving.push_back(row(Hit{p, n, error}, to, rt::inf));
        who.push_back(i);
    }
    if (who.size() < count / 2) return rt::inf;
    const Rows left = ask.probe("shadow_ray", leaving);
    rows.clear();
    for (std::size_t k = 0; k < who.size(); ++k) rows.push_back(walls[who[k]].row_with(from_row<Ray>(left[k])));
    const Rows again = ask.probe(fragment_of(kind), rows);
    int caught = 0;
    for (const Row& out : again) caught += out.at(0) != rt::inf;
    return double(caught) / double(who.size());
}

/// How far a shadow ray starts from its surface, over the size of the scene.
double shadow_offset(double x, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const vec3 point = x * box(draw, -2, 2), n = direction(draw);
        return row(Hit{point, n, 64 * rt::roundoff * x}, tilted(draw, n, between(draw, 0, 1.5)), 5 * x);
    })(random);
    return worst_of<rt::shadow_ray>(ask, "shadow_ray", rows, [=](const Ray& ray, const Hit& hit, vec3, double) {
        return rt::largest(ray.origin + ray.near * ray.direction - hit.point) / x;
    });
}

/// How far before the light a shadow ray ends, over the light's distance; inf where it does not.
double shadow_end(double x, Generator& random, const Asker& ask) {
    Rows rows;
    for (int i = 0; i < 100; ++i) {
        const vec3 n = direction(random);
        rows.push_back(row(Hit{x * box(random, -1, 1), n, 64 * rt::roundoff * x},
                           tilted(random, n, between(random, 0, 1.5)), x * between(random, 1, 5)));
    }
    return worst_of<rt::shadow_ray>(ask, "shadow_ray", rows, [](const Ray& ray, const Hit&, vec3, double distance) {
        return ray.far < distance * (1 - 8 * rt::roundoff) && ray.far > 0 ? (distance - ray.far) / distance : rt::inf;
    });
}

}  // namespace

std::vector<Family> leaving_families() {
    std::vector<Family> all;
    for (const Surface kind : {Surface::sphere, Surface::quad, Surface::triangle}) {
        const std::string hit = fragment_of(kind);
        all.push_back(
            Family("self_" + hit, {"shadow_ray", hit}, "size of the scene [m]",
                   "share of rays that meet the surface they leave", {.tolerance = 0.01, .decades = sweep(-60, 60, 3)},
                   [=](double x, Generator& random, const Asker& ask) { return self_hits(kind, x, random, ask); }));
    }
    all.insert(
        all.end(),
        {Family("shadow_offset", {"shadow_ray"}, "size of the scene [m]", "gap between surface and ray / size",
                {.tolerance = 5e-3, .bound = 1e-9, .decades = sweep(-60, 60, 3)}, shadow_offset),
         Family("shadow_end", {"shadow_ray"}, "distance of the light [m]", "gap between ray and light / distance",
                {.tolerance = 5e-3, .bound = 1e-6, .decades = sweep(-60, 60, 3)}, shadow_end)});
    return all;
}

}  // namespace grade::stress
