#include "rt/plan.h"

#include <fmt/format.h>

#include "rt/media/bodies.h"

namespace rt {
namespace {

/// With fewer, a loop over the rays for each shape is faster: see the lamps of tests/bench/growth.md.
constexpr std::size_t shapes_without_tree = 100;

/// Both ways on at each surface may be 2^depth rays.
constexpr int deepest_split = 24;

/// Paths of so many scatterings or bounces end at random if less than this is left of their light: see
/// tests/bench/walks.py.
constexpr Real fewest_scatterings = 4, fewest_bounces = 12, little = 0.5;

std::vector<int> find_lamps(const Scene& scene) {
    std::vector<int> lamps;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        if (aim_at(shape, scene.materials[std::size_t(shape.material)]) == Aim::possible) lamps.push_back(int(i));
    }
    return lamps;
}

bool has_quad_among(const std::vector<int>& lamps, const Scene& scene) {
    return std::any_of(lamps.begin(), lamps.end(), [&](int lamp) {
        return std::holds_alternative<Quad>(scene.shapes[std::size_t(lamp)].geometry);
    });
}

/// What surfaces do with light.
void add_materials(const Scene& scene, RenderPlan& plan) {
    for (const int i : materials_in_use(scene)) {
        const Material& m = scene.materials[std::size_t(i)];
        const bool dielectric = m.transmittance != Color(0), mirror = m.reflectance != Color(0),
                   sharp = m.exponent == inf;
        plan.checker |= m.checker.has_value();
        const bool diffuse = largest_albedo(m) != Color(0);
        plan.diffuse |= diffuse;
        plan.ambient |= m.ambient != Color(0) && scene.ambient != Color(0);
        plan.phong |= m.specular != Color(0);
        plan.emission |= m.emission != Color(0);
        plan.medium |= dielectric && m.medium.extinction > 0;
        plan.through |= goes_straight_through(m);
        plan.lobe |= (dielectric || mirror) && !sharp;
        plan.specular |= (dielectric || mirror) && sharp;
        plan.mirrors |= mirror && sharp && scene.depth > 0;
        plan.glass |= dielectric && sharp && scene.depth > 0;
        plan.glossy |= mirror && !sharp && scene.depth > 0;
        plan.translucent |= dielectric && !sharp && scene.depth > 0;
        plan.choice |= (diffuse && scene.bounces > 0 && (dielectric || mirror)) || (dielectric && mirror);
    }
}

/// What there is to hit.
void add_shapes(const Scene& scene, RenderPlan& plan) {
    std::size_t count = scene.shapes.size();
    for (const Shape& shape : scene.shapes) {
        plan.time |= shape.velocity != vec3(0);
        plan.spheres |= std::holds_alternative<Sphere>(shape.geometry);
        plan.triangles |= std::holds_alternative<Triangle>(shape.geometry);
        plan.quads |= std::holds_alternative<Quad>(shape.geometry);
        plan.discs |= std::holds_alternative<Disc>(shape.geometry);
    }
    for (const Mesh& mesh : scene.meshes) {
        plan.time |= mesh.velocity != vec3(0);
        plan.triangles |= !mesh.triangles.empty();
        plan.smooth |= !mesh.normals.empty();
        count += mesh.triangles.size();
    }
    plan.bvh = count > shapes_without_tree;
}

/// Whether a medium scatters from where shadow rays get out.
bool scatters_into_the_open(const Scene& scene) {
    const std::vector<Body> bodies = scattering_bodies(scene);
    return std::any_of(bodies.begin(), bodies.end(),
                       [](const Body& body) { return goes_straight_through(*body.material); });
}

/// Whether paths end at random: where some that are long lose most of what they carry.
void decide_roulette(const Scene& scene, RenderPlan& plan) {
    Real longest = 0, left = 1;
    bool is_long = false;
    const auto follow = [&](Real steps, Color albedo, Real fewest) {
        longest = std::max(longest, steps);
        if (steps >= fewest) is_long = true, left = std::min(left, std::pow(largest(albedo), steps));
    };
    for (const Body& body : scattering_bodies(scene))
        follow(mean_scatterings(body), body.material->medium.albedo, fewest_scatterings);
    if (plan.bounce) {
        Color albedo{0};
        for (const Material& m : scene.materials) albedo = glm::max(albedo, largest_albedo(m));
        follow(scene.bounces, albedo, fewest_bounces);
    }
    plan.roulette = longest > 0 && scene.roulette.value_or(left < little);
    const std::string long_enough = fmt::format(
        "{:.2g} of the light is left after {:.3g} scatterings or bounces; worth it below {:g}", left, longest, little);
    const std::string too_short = fmt::format("{:.3g} scatterings or bounces; worth it from {} or {}", longest,
                                              fewest_scatterings, fewest_bounces);
    plan.ends_early = longest == 0     ? "no path bounces or is scattered in media"
                      : scene.roulette ? "the scene says so"
                      : is_long        ? long_enough
                                       : too_short;
}

LitByLamps lit_by_lamps(const RenderPlan& plan, const Scene& scene) {
    if (plan.lamps.empty()) return {false, false, false};
    return {plan.diffuse || plan.phong, plan.lobe, scatters_into_the_open(scene)};
}

/// Whether lamps are sampled, and how.
void decide_lamps(const Scene& scene, RenderPlan& plan) {
    const LitByLamps lit = plan.lit = lit_by_lamps(plan, scene);
    if (lit.surfaces || lit.lobes || lit.media) plan.ways = choose_ways(scene, plan.lamps);
    plan.weigh = lit.lobes && plan.ways.multiple_importance.on;
    plan.media_lit = lit.media && plan.ways.media_lit.on;
    plan.light = lit.surfaces || plan.weigh || plan.media_lit;
    plan.quad_lamps = plan.light && has_quad_among(plan.lamps, scene);
    plan.solid_angle = plan.quad_lamps && plan.ways.solid_angle.on;
    plan.one_lamp = plan.light && plan.ways.one_lamp.on && plan.lamps.size() > 1;
}

/// Numbers the dimensions that are drawn, without gaps.
void number_pairs(RenderPlan& plan) {
    plan.pairs.assign(std::size_t(plan.camera_dimensions + plan.wave_dimensions + most_new_dimensions), -1);
    int next = 0;
    for (const DrawnDimension& d : camera_drawn(plan)) plan.pairs[std::size_t(d.dimension)] = next++;
    const int before = next;
    for (const DrawnDimension& d : wave_drawn(plan)) plan.pairs[plan.place(d.dimension)] = next++;
    plan.pairs_of_wave = next - before;
}

}  // namespace

std::vector<DrawnDimension> camera_drawn(const RenderPlan& plan) {
    std::vector<DrawnDimension> drawn;
    if (plan.pixel) drawn.push_back({pixel_dimension, 2});
    if (plan.lens) drawn.push_back({lens_dimension, 2});
    if (plan.time) drawn.push_back({time_dimension, 1});
    return drawn;
}

std::vector<DrawnDimension> wave_drawn(const RenderPlan& plan) {
    std::vector<DrawnDimension> drawn;
    const auto add = [&](int dimension, int numbers, bool on) {
        if (on) drawn.push_back({dimension, numbers});
    };
    for (int light = light_dimension; light < plan.wave_dimensions; ++light)
        add(light, plan.one_lamp && light > light_dimension ? 1 : 2, plan.light);
    add(environment_dimension, 2, plan.environment_lit);
    add(lobe_dimension, 2, plan.lobe || plan.bounce);
    add(choice_dimension, 1, plan.choice);
    add(flight_dimension, 1, plan.medium);
    add(phase_dimension, 2, plan.medium);
    add(roulette_dimension, 1, plan.roulette);
    return drawn;
}

std::vector<int> materials_in_use(const Scene& scene) {
    std::vector<char> used(scene.materials.size(), 0);
    for (const Shape& shape : scene.shapes) used[std::size_t(shape.material)] = 1;
    for (const Mesh& mesh : scene.meshes)
        if (!mesh.triangles.empty()) used[std::size_t(mesh.material)] = 1;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < used.size(); ++i)
        if (used[i]) numbers.push_back(int(i));
    return numbers;
}

Aim aim_at(const Shape& shape, const Material& material) {
    if (material.emission == Color(0) || !material.sampled) return Aim::not_asked;
    const bool elusive = std::holds_alternative<Triangle>(shape.geometry) || shape.velocity != vec3(0);
    return elusive ? Aim::impossible : Aim::possible;
}

RenderPlan make_plan(const Scene& scene, const Sampling& sampling) {
    RenderPlan plan;
    add_materials(scene, plan);
    add_shapes(scene, plan);
    plan.lamps = find_lamps(scene);
    plan.sampling = sampling;
    plan.pixel = sampling.samples > 1 || sampling.passes || sampling.one_of_many;
    plan.lens = scene.camera.lens_radius > 0;
    plan.time = plan.time && scene.shutter.close > scene.shutter.open;
    plan.point_lights = !scene.lights.empty();
    decide_lamps(scene, plan);
    plan.environment = scene.environment != Color(0);
    plan.environment_lit = plan.environment && plan.diffuse;
    plan.bounce = plan.diffuse && scene.bounces > 0;
    plan.through = plan.through && (plan.point_lights || plan.light || plan.environment_lit);
    plan.split = plan.specular && scene.depth <= deepest_split && !plan.lobe && !plan.bounce && !plan.medium &&
                 !plan.light && !plan.environment_lit;
    plan.choice = plan.choice && !plan.split;
    decide_roulette(scene, plan);
    // A diffuse ray goes as a shadow ray to the environment would, and so costs nothing more. But one that goes on by
    // chance brings it with more noise, boundaries that let shadow rays through count as depth for it, and interpolated
    // normals may send it through its own surface.
    plan.sky_by_bounces = plan.environment_lit && plan.bounce && !plan.choice && !plan.roulette && !plan.smooth &&
                          (!plan.through || scene.depth >= Scene{}.depth);
    plan.counts_twice = plan.bounce && (plan.emission || (plan.environment_lit && !plan.sky_by_bounces));
    plan.camera_dimensions = camera_dimensions;
    plan.wave_dimensions = light_dimension + (plan.one_lamp ? 2 : int(plan.lamps.size()));
    number_pairs(plan);
    return plan;
}

}  // namespace rt
