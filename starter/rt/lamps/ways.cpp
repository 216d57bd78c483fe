#include "rt/lamps/ways.h"

#include <fmt/format.h>

#include "rt/lamps/importance.h"
#include "rt/lamps/lamp_tree.h"
#include "rt/lamps/sight.h"
#include "rt/media/bodies.h"

/// A way takes a time that goes with its variance and with what a sample costs: that with the least product is taken.
/// Both are reckoned before any ray is sent, at some points that are seen. Shadows between them and the lamps are left
/// out: at so few points, they change a choice for the worse as often as for the better.
namespace rt {
namespace {

/// How lamps are sampled.
struct Technique {
    bool angle = false, one = false, weighed = false;
};

/// What a point of a lamp with its shadow ray costs, a solid angle, the choice of a lamp, a weight against a lobe; a
/// ray to a surface is 1. Fitted to the times of scenes of tests/bench/choices.py.
constexpr Real cost_of_lamp = 0.8, cost_of_angle = 1.3, cost_of_choice = 2, cost_of_weight = 2.5;

/// What a lamp's shadows add to its variance, over the square of its light; and to that of all, the directions of
/// bounces and everything else, however lamps are sampled.
constexpr Real noise_of_shadows = 0.3, noise_of_bounces = 0.15, noise_of_rest = 0.04;

/// Patterns of samples even out the noise of lamps more than that of edges, which counts as much as this.
constexpr Real weight_of_edges = 1.75;

/// The share of lobes that are taken to point anywhere: points in sight are few, and may miss the one that a sharp lobe
/// shows a lamp at.
constexpr Real unforeseen = 0.03;

/// Of fewer lamps, none is chosen: there is little to save. Of more, one is: with all, a first sample of each pixel
/// takes longer than a picture may.
constexpr std::size_t fewest_to_choose = 4, most_to_take = 256;

/// From where on lamps are sampled where media scatter: for each lamp, which takes a shadow ray; and where one is
/// chosen. See tests/bench/walks.py.
constexpr Real worth_lighting_media = 0.6, worth_lighting_media_by_one = 1;

/// Lines of sight times shapes, and points times parts of lamps: a plan takes milliseconds. A point takes as long as a
/// few samples do; with one for many samples, the plan takes a small share of the time.
constexpr Real most_work = 1.5e5, samples_for_point = 200, fewest_points = 256;

/// A lamp as a quad of its area, which faces the point where it is a ball.
Quad as_quad(const Emitter& lamp, vec3 p) {
    if (lamp.kind == Emitter::Kind::quad) return lamp.quad;
    const Frame frame = frame_about(lamp.kind == Emitter::Kind::disc ? lamp.disc.normal : unit(p - lamp.sphere.center));
    const Real half = std::sqrt(area(lamp)) / 2;
    return {center(lamp), half * frame.x, half * frame.y};
}

/// Calls f with the ways from a point to the middles of the parts of a lamp, all of one area, and with the cosine there
/// times the way's length: below 0, where the lamp does not shine.
template <class F>
void for_parts(const Emitter& lamp, vec3 p, F f) {
    constexpr int side = 4;
    const Quad quad = as_quad(lamp, p);
    const vec3 n = unit(cross(quad.u, quad.v));
    for (int k = 0; k < side * side; ++k) {
        const vec2 at{(2 * (k % side) + 1.0) / side - 1, (2 * (k / side) + 1.0) / side - 1};
        const vec3 to = quad.center + at.x * quad.u + at.y * quad.v - p;
        f(to, -dot(n, to));
    }
}
constexpr int parts = 16;

/// What a lamp of radiance 1 sends to a point.
struct Light {
    Real mean = 0;    // irradiance
    Real within = 0;  // variance of a sample by area
    Real excess = 0;  // and how much of it one by solid angle would not have
    Real share = 0;   // of the rays of a lobe, that find it
};

Light light_of(const Emitter& lamp, const Point& p) {
    const bool lobe = p.material->exponent < inf && p.material->reflectance != Color(0);
    const Real whole = area(lamp), part = whole / parts;
    Real angle = 0, by_area = 0, by_angle = 0;
    Light light;
    for_parts(lamp, p.place, [&](vec3 to, Real facing) {
        const Real square = dot(to, to), cosine = dot(p.normal, to) / std::sqrt(square);
        const Real seen = facing / (square * std::sqrt(square));
        if (!(cosine > 0 && seen > 0)) return;
        angle += part * seen, light.mean += part * cosine * seen;
        by_area += part * whole * sqr(cosine * seen), by_angle += part * sqr(cosine) * seen;
        if (lobe) light.share += part * seen * lobe_density(p.material->exponent, unit(to), p.normal, p.to_viewer);
    });
    light.within = std::max<Real>(by_area - sqr(light.mean), 0);
    if (lamp.kind == Emitter::Kind::quad) light.excess = std::max<Real>(by_area - angle * by_angle, 0);
    if (lobe) light.share = glm::mix(std::min<Real>(light.share, 1), std::min<Real>(angle / (2 * pi), 1), unforeseen);
    return light;
}

Real sum(Color c) { return c.x + c.y + c.z; }

/// What there is at the points in sight: sums of variances and squares, and how many points there are of each kind.
struct Survey {
    Real of_all = 0, of_one = 0;                // of lamps by area, if each is sampled and if one is
    Real excess_of_all = 0, excess_of_one = 0;  // and how much of that solid angles would not have
    Real of_lobes = 0, of_lobes_and_one = 0;    // of lobes alone, and weighed against the one lamp
    Real points = 0, matt = 0, glossy = 0, either = 0;
    Real square = 0;   // of the light
    Real for_any = 0;  // whatever the way, over that square
    Real lamps = 0, quads = 0;
};

/// Adds a point. Returns the light that it sends to the viewer.
Real add_point(const std::vector<Emitter>& lamps, const LampTree& tree, const Point& p, Survey& s) {
    const Real diffuse = sum(largest_albedo(*p.material) + p.material->specular) / pi,
               lobe = p.material->exponent < inf ? sum(p.material->reflectance) : 0;
    Real by_surfaces = 0, by_lobes = 0, squares = 0;
    for (std::size_t l = 0; l < lamps.size(); ++l) {
        const Light from = light_of(lamps[l], p);
        const Real by_surface = diffuse * sum(lamps[l].radiance), by_lobe = lobe * sum(lamps[l].radiance),
                   within = sqr(by_surface) * (from.within + noise_of_shadows * sqr(from.mean)),
                   excess = sqr(by_surface) * from.excess, chosen = tree.probability(l, p.place),
                   missed = 1 - from.share;
        by_surfaces += by_surface * from.mean, by_lobes += by_lobe * from.share;
        squares += (sqr(by_surface * from.mean) + within) / chosen;
        s.of_all += within, s.excess_of_all += excess, s.excess_of_one += excess / chosen;
        s.of_lobes += sqr(by_lobe) * from.share * missed;
        s.of_lobes_and_one += sqr(by_lobe) * from.share * std::min(missed, from.share * (1 / chosen - 1));
    }
    s.of_one += squares - sqr(by_surfaces);
    s.points += 1, s.matt += diffuse > 0, s.glossy += lobe > 0, s.either += diffuse > 0 || lobe > 0;
    s.square += sqr(by_surfaces + by_lobes);
    return by_surfaces + by_lobes;
}

/// What pixels on edges of shapes add to the variance: where two parts of the film beside each other see other shapes,
/// an edge is between them. light  of the view's points
Real noise_of_edges(const Scene& scene, const View& view, const std::vector<Real>& light) {
    const auto shape = [&](int part) {
        const int k = view.on_film[std::size_t(part)];
        return k < 0 ? nullptr : view.points[std::size_t(k)].shape;
    };
    const auto bright = [&](int part) {
        const int k = view.on_film[std::size_t(part)];
        return k < 0 ? sum(scene.background)
                     : light[std::size_t(k)] + sum(view.points[std::size_t(k)].material->emission);
    };
    const int side = view.side;
    Real noise = 0;
    // The share x of a pixel on one side of an edge is between 0 and 1: the mean of x (1 - x) is 1/6.
    const auto add = [&](int part, int other, int pixels) {
        if (shape(part) != shape(other)) noise += sqr(bright(part) - bright(other)) / 6 * side / pixels;
    };
    for (int k = 0; k < side * side; ++k) {
        if (k % side > 0) add(k, k - 1, scene.camera.size.x);
        if (k >= side) add(k, k - side, scene.camera.size.y);
    }
    return noise;
}

Survey survey_of(const Scene& scene, const std::vector<Emitter>& lamps) {
    const Real work = Real(scene.shapes.size() + 16 * lamps.size());
    const Real samples = Real(scene.samples) * scene.camera.size.x * scene.camera.size.y;
    const Real points = std::min(most_work / work, std::max(samples / samples_for_point, fewest_points));
    const View view = view_of(scene, std::clamp(int(std::sqrt(points)), 4, 48));
    const LampTree tree(lamps);
    Survey s;
    std::vector<Real> light;
    for (const Point& p : view.points) light.push_back(add_point(lamps, tree, p, s));
    s.lamps = Real(lamps.size());
    for (const Emitter& lamp : lamps) s.quads += lamp.kind == Emitter::Kind::quad;
    s.for_any = weight_of_edges * noise_of_edges(scene, view, light) / s.square + noise_of_rest +
                (scene.bounces > 0 ? noise_of_bounces : 0);
    return s;
}

Real noise_of(const Survey& s, Technique w) {
    const Real by_area = w.one ? s.of_one : s.of_all, excess = w.one ? s.excess_of_one : s.excess_of_all,
               lobes = !w.weighed ? s.of_lobes
                       : w.one    ? s.of_lobes_and_one
                                  : 0;
    return s.for_any + (std::max<Real>(by_area - w.angle * excess, 0) + lobes) / s.square;
}

Real cost_of(const Survey& s, Technique w) {
    const Real lamps = w.one ? 1 : s.lamps, quads = w.one ? s.quads / s.lamps : s.quads;
    const Real at_each = cost_of_lamp * lamps + w.angle * cost_of_angle * quads + w.one * cost_of_choice;
    return 1 + ((w.weighed ? s.either : s.matt) * at_each + w.weighed * s.glossy * cost_of_weight * lamps) / s.points;
}

/// The share of all directions in which a lamp is seen.
Real share_of_directions(const Emitter& lamp, vec3 p) {
    Real angle = 0;
    for_parts(lamp, p, [&](vec3 to, Real facing) {
        const Real square = dot(to, to);
        angle += area(lamp) / parts * std::max<Real>(facing, 0) / (square * std::sqrt(square));
    });
    return std::min<Real>(angle / (4 * pi), 0.5);
}

/// The variance of the light that a random direction finds at places below the surface of bodies whose scatterings
/// shadow rays can leave. Lamps stand out against the environment.
Real noise_in_media(const Scene& scene, const std::vector<Emitter>& lamps) {
    const std::vector<Body> bodies = scattering_bodies(scene);
    const std::size_t step = 1 + std::size_t(Real(bodies.size() * lamps.size()) * 6 * 16 / most_work);
    const Real around = sum(scene.environment);
    Real noise = 0, all = 0;
    for (std::size_t k = 0; k < bodies.size(); k += step) {
        if (!goes_straight_through(*bodies[k].material)) continue;
        const vec3 center = (bodies[k].box.low + bodies[k].box.high) / 2.0, half = bodies[k].box.high - center;
        for (int side = 0; side < 6; ++side) {
            vec3 place = center;
            place[side / 2] += (side % 2 ? 0.8 : -0.8) * half[side / 2];
            Real mean = around;
            for (const Emitter& lamp : lamps) {
                const Real share = share_of_directions(lamp, place), brighter = sum(lamp.radiance) - around;
                mean += share * brighter, noise += share * (1 - share) * sqr(brighter);
            }
            all += sqr(mean);
        }
    }
    return all > 0 ? noise / all : 0;
}

/// What the scene says of each choice, or what is to be the case.
struct Said {
    std::optional<bool> angle, one, weighed;

    bool allows(Technique w) const {
        return angle.value_or(w.angle) == w.angle && one.value_or(w.one) == w.one &&
               weighed.value_or(w.weighed) == w.weighed;
    }
};

Technique best_way(const Survey& s, const Said& said) {
    Technique best{said.angle.value_or(false), said.one.value_or(false), said.weighed.value_or(false)};
    Real least = inf;
    for (int k = 0; k < 8; ++k) {
        const Technique w{(k & 1) != 0, (k & 2) != 0, (k & 4) != 0};
        const Real time = s.square > 0 ? noise_of(s, w) * cost_of(s, w) : k;
        if (said.allows(w) && time < least) least = time, best = w;
    }
    return best;
}

/// Why a way is better than another.
std::string reason(const Survey& s, Technique way, Technique other) {
    if (!(s.square > 0)) return "no light of theirs is seen";
    return fmt::format("otherwise {:.2g} times the variance at {:.2g} times the cost",
                       noise_of(s, other) / noise_of(s, way), cost_of(s, other) / cost_of(s, way));
}

void choose_at_surfaces(const Scene& scene, const std::vector<Emitter>& lamps, LampWays& ways) {
    const bool few = lamps.size()<fewest_to_choose, many = lamps.size()> most_to_take;
    Said said{scene.solid_angle, scene.one_lamp, scene.multiple_importance};
    if (!said.one && (few || many)) said.one = many;
    Survey s;
    if (!said.angle || !said.one || !said.weighed) s = survey_of(scene, lamps);
    const Technique best = best_way(s, said);
    const auto way = [&](std::optional<bool> by_scene, bool on, bool Technique::*choice) -> LampWays::Way {
        Technique other = best;
        other.*choice = !on;
        return {on, by_scene ? "the scene says so" : reason(s, best, other)};
    };
    ways.solid_angle = way(scene.solid_angle, best.angle, &Technique::angle);
    ways.one_lamp = way(scene.one_lamp, best.one, &Technique::one);
    ways.multiple_importance = way(scene.multiple_importance, best.weighed, &Technique::weighed);
    if (!scene.one_lamp && few) ways.one_lamp.why = fmt::format("worth it from {} lamps", fewest_to_choose);
    if (!scene.one_lamp && many) ways.one_lamp.why = fmt::format("there are more than {}", most_to_take);
}

}  // namespace

LampWays choose_ways(const Scene& scene, const std::vector<int>& lamps) {
    std::vector<Emitter> emitters;
    for (const int lamp : lamps) {
        const Shape& shape = scene.shapes[std::size_t(lamp)];
        const Color radiance = scene.materials[std::size_t(shape.material)].emission;
        const auto add = [&](const auto& s) {
            if constexpr (!std::is_same_v<decltype(s), const Triangle&>) emitters.push_back(emitter(s, radiance));
        };
        std::visit(add, shape.geometry);
    }
    LampWays ways;
    choose_at_surfaces(scene, emitters, ways);
    const Real in_media = scene.media_lit ? 0 : noise_in_media(scene, emitters),
               least = ways.one_lamp.on ? worth_lighting_media_by_one : worth_lighting_media * Real(lamps.size());
    ways.media_lit = {scene.media_lit.value_or(in_media > least),
                      scene.media_lit
                          ? "the scene says so"
                          : fmt::format("without, a variance of {:.2g} more; worth it from {:.2g}", in_media, least)};
    return ways;
}

}  // namespace rt
