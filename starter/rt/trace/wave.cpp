#include "rt/fragments.h"
#include "rt/trace/words.h"

namespace rt {
namespace {

constexpr const char* event_names[] = {"the camera", "a diffuse surface", "a mirror or glass", "a lobe", "a medium"};

constexpr const char* event_words[] = {"camera", "diffuse", "specular", "lobe", "medium"};

/// Who says that there is nothing along a ray.
std::string witnesses(const RenderPlan& plan) {
    std::string names;
    const auto add = [&](bool on, const char* name) {
        names += on ? (names.empty() ? "" : ", ") + std::string(name) : "";
    };
    add(plan.spheres, "hit_sphere"), add(plan.triangles, "hit_triangle"), add(plan.quads, "hit_quad");
    return names.empty() ? "there is nothing to meet" : names + " say so";
}

void tell_medium(const Wave& wave, int i, Told& told) {
    const Batch& b = wave.batch;
    const Index medium = wave.world.plan.medium ? wave.world.regions.medium(b.inside[i]) : nothing;
    if (medium == nothing) return;
    const Scene& scene = wave.world.scene;
    const Real u = number_of(wave, i, flight_dimension);
    const Real t = free_flight(scene.materials[std::size_t(medium)].medium.extinction, u);
    tell(told, "free_flight", "in {}, u {}: {} m{}", name_of_material(scene, medium), text(u), text(t),
         b.shape[i] == ended ? ", before any surface" : ", beyond the surface");
    if (b.shape[i] == ended) trace_scattered(wave, i, medium, b.origin.at(i) + t * b.direction.at(i), told);
}

void tell_hit(const Wave& wave, int i, Told& told) {
    const World& world = wave.world;
    const Batch& b = wave.batch;
    const Surfaces& s = wave.surfaces;
    const SurfaceRecord& record = world.surfaces[std::size_t(b.shape[i])];
    if (world.plan.time && record.velocity != vec3(0))
        tell(told, "moved", "at {} s: {} is at {}", text(b.time[i]), text(record.center),
             text(moved(record.center, record.velocity, b.time[i])));
    tell(told, hit_name(world, b.shape[i]), "{} m: shape {}, material {}, seen from {}", text(b.far[i]), b.shape[i],
         name_of_material(world.scene, s.material[i]), s.behind[i] ? "behind" : "the front");
    tell(told, "", "point {}, normal {}", text(s.hit(i).point), text(s.normal(i)));
}

/// What a ray sees that shines.
void tell_emission(const Wave& wave, int i, Told& told) {
    const World& world = wave.world;
    const Batch& b = wave.batch;
    const Event from = Event(b.event[i]);
    const RenderPlan& plan = world.plan;
    const auto counts = [&](bool sampled) {
        if (!plan.counts_twice) return true;
        const bool answer = emission_counts(from, sampled);
        tell(told, "emission_counts", "from {}, {} by shadow rays: {}", event_names[b.event[i]],
             sampled ? "looked for" : "not looked for", answer ? "yes" : "no");
        return answer;
    };
    if (b.shape[i] == nothing) {
        if (!plan.environment && world.scene.background == Color(0)) return;
        const bool seen = plan.environment && (plan.sky_by_bounces || counts(plan.environment_lit));
        const Color sky = seen ? world.scene.environment : Color(0);
        const Color light = sky + (from == Event::camera ? world.scene.background : Color(0));
        tell(told, "sky", "{}", text(light));
        if (light != Color(0)) tell_added(told, b.weight.at(i) * light);
        return;
    }
    if (b.shape[i] < 0 || !plan.emission || !wave.surfaces.shines[i]) return;
    const SurfaceRecord& lamp = world.surfaces[std::size_t(b.shape[i])];
    const bool sampled = lamp.emitter != nothing;
    const Color emission = world.scene.materials[std::size_t(wave.surfaces.material[i])].emission;
    tell(told, "shines", "{}", text(emission));
    if (!counts(sampled)) return;
    const std::optional<Real> share = share_of_found(world, lamp, b, i);
    if (share) tell(told, event_words[b.event[i]], "weight against the lamp's points {}", text(*share));
    tell_added(told, share.value_or(1) * b.weight.at(i) * emission);
}

}  // namespace

void trace_wave(const Wave& wave, Trace& trace) {
    const Batch& b = wave.batch;
    for (int i = 0; i < b.count; ++i) {
        Told& told = trace.of(b, i);
        if (wave.number > 0) {
            const std::string along = wave.world.plan.split ? fmt::format(", along {}", text(b.direction.at(i))) : "";
            told.text += fmt::format(" ray {}, from {}{}, carries {}\n", wave.number, event_names[b.event[i]], along,
                                     text(b.weight.at(i)));
        }
        tell_medium(wave, i, told);
        if (b.shape[i] == nothing) tell(told, "meets nothing", "{}", witnesses(wave.world.plan));
        if (b.shape[i] >= 0) tell_hit(wave, i, told);
        tell_emission(wave, i, told);
        if (b.shape[i] >= 0) trace_lights(wave, i, told);
    }
}

}  // namespace rt
