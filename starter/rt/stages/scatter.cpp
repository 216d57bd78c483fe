#include "rt/stages/stages.h"

namespace rt {
namespace {

Real strongest(Color c) { return largest(c); }

/// Puts the next ray of lane i's path in the queue.
void send(const Batch& b, int i, const Ray& ray, Color weight, Event event, Index medium, Bits branch, Queue& next) {
    const auto [to, j] = next.push();
    to.set_ray(j, ray);
    to.time[j] = b.time[i];
    to.set_weight(j, weight);
    to.key[j] = branch == 0 ? b.key[i] : combine(b.key[i], branch);
    to.sample[j] = b.sample[i];
    to.slot[j] = b.slot[i];
    to.event[j] = Index(event);
    to.depth[j] = b.depth[i] + (event == Event::specular || event == Event::lobe);
    to.bounce[j] = b.bounce[i] + (event == Event::diffuse);
    to.medium[j] = medium;
}

/// One lane's surface, and the ways on from there.
struct Crossing {
    const Material& material;
    Hit hit;
    vec3 normal;     // shading normal, on the side of the ray
    vec3 direction;  // of the ray
    bool behind;
    Real ior_from, ior_to;
    vec2 u;          // for a lobe or a bounce
};

void mirror(const Crossing& c, const Batch& b, int i, Color weight, Queue& next, Chunk& chunk) {
    const bool perfect = c.material.exponent == inf;
    Scattered way{vec3(0), Color(1)};
    if (perfect)
        way.direction = mirror_direction(c.direction, c.normal);
    else
        way = glossy_reflection(c.direction, c.normal, c.material.exponent, c.u);
    if (way.weight == Color(0)) return;
    send(b, i, spawn_ray(c.hit, way.direction), weight * way.weight, perfect ? Event::specular : Event::lobe,
         b.medium[i], 0, next);
    ++chunk.rays[int(perfect ? RayKind::mirror : RayKind::lobe)];
}

void glass(const Crossing& c, const Batch& b, int i, Index material, Color weight, Queue& next, Chunk& chunk) {
    const bool perfect = c.material.exponent == inf;
    Scattered way{vec3(0), Color(1)};
    if (perfect)
        way.direction = refracted_direction(c.direction, c.normal, c.ior_from, c.ior_to);
    else
        way = translucency(c.direction, c.normal, c.ior_from, c.ior_to, c.material.exponent, c.u);
    if (way.weight == Color(0) || way.direction == vec3(0)) return;
    const Index inside = c.behind || c.material.medium.extinction == 0 ? nothing : material;
    send(b, i, spawn_ray(c.hit, way.direction), weight * way.weight, perfect ? Event::specular : Event::lobe, inside, 1,
         next);
    ++chunk.rays[int(perfect ? RayKind::glass : RayKind::lobe)];
}

void bounce(const Crossing& c, const Batch& b, int i, Color weight, Queue& next, Chunk& chunk) {
    const Scattered way = color_bleeding(c.normal, c.material.albedo, c.u);
    if (way.weight == Color(0)) return;
    send(b, i, spawn_ray(c.hit, way.direction), weight * way.weight, Event::diffuse, b.medium[i], 0, next);
    ++chunk.rays[int(RayKind::bounce)];
}

}  // namespace

void scatter_stage(const World& world, Sampler sampler_in_use, int n, int wave, const Batch& b, const Surfaces& s,
                   Queue& next, Chunk& chunk) {
    const RenderPlan& plan = world.plan;
    if (!plan.specular && !plan.lobe && !plan.bounce) return;
    const Bits choice = wave_dimension(world, wave, choice_dimension),
               lobe = wave_dimension(world, wave, lobe_dimension);
    with_sampler(sampler_in_use, [&](auto sampler) {
        for (int i = 0; i < b.count; ++i) {
            if (s.material[i] == nothing) continue;
            const Material& m = world.scene.materials[std::size_t(s.material[i])];
            Crossing c{m, s.hit(i), s.normal(i), {b.dx[i], b.dy[i], b.dz[i]}, s.behind[i] != 0, 1, m.ior, vec2(0)};
            if (c.behind) std::swap(c.ior_from, c.ior_to);
            const Color weight = b.weight(i);

            // What each way on would carry.
            const bool deeper = b.depth[i] < world.scene.depth && (plan.specular || plan.lobe);
            const bool dielectric = deeper && m.transmittance != Color(0);
            const Real fresnel = dielectric ? fresnel_dielectric(-dot(c.direction, c.normal), c.ior_from, c.ior_to) : 0;
            const Outgoing out = deeper ? whitted(m, fresnel) : Outgoing{Color(1), Color(0), Color(0)};
            const Real mirror_share = deeper ? strongest(out.mirror) : 0,
                       glass_share = deeper ? strongest(out.glass) : 0;
            const Real bounce_share = b.bounce[i] < world.scene.bounces ? strongest(out.local * m.albedo) : 0;
            const Real sum = mirror_share + glass_share + bounce_share;
            if (sum == 0) continue;
            if (plan.lobe || plan.bounce) c.u = pattern_2d<sampler()>(b.key[i], int(b.sample[i]), n, lobe);

            if (plan.split) {
                if (mirror_share > 0) mirror(c, b, i, weight * out.mirror, next, chunk);
                if (glass_share > 0) glass(c, b, i, s.material[i], weight * out.glass, next, chunk);
                continue;
            }
            // One of them, with a probability in proportion to what it carries.
            const bool alone = mirror_share == sum || glass_share == sum || bounce_share == sum;
            const Real u = alone ? 0 : sum * pattern_1d<sampler()>(b.key[i], int(b.sample[i]), n, choice);
            if (u < mirror_share)
                mirror(c, b, i, weight * out.mirror * (sum / mirror_share), next, chunk);
            else if (u < mirror_share + glass_share)
                glass(c, b, i, s.material[i], weight * out.glass * (sum / glass_share), next, chunk);
            else
                bounce(c, b, i, weight * out.local * (sum / bounce_share), next, chunk);
        }
    });
}

}  // namespace rt
