#include "asked/whitted.h"
#include "checks/kit/glass.h"
#include "checks/kit/kit.h"

namespace grade {

namespace {

using rt::Color, rt::Material, rt::Outgoing;

bool is_glass(const Material& m) { return m.transmittance != Color(0); }

/// glass  whether it counts as such
Outgoing weights(const Material& m, double fresnel, bool glass) {
    return glass ? Outgoing{Color(1), fresnel * m.reflectance, (1 - fresnel) * m.transmittance}
                 : Outgoing{Color(1), m.reflectance, Color(0)};
}

/// The right weights, changed for glass or for opaque surfaces, or for both.
template <class Change>
auto where(bool for_glass, bool for_opaque, Change change) {
    return [=](Outgoing right, const Material& m, double fresnel) {
        if (is_glass(m) ? for_glass : for_opaque) change(right, m, fresnel);
        return right;
    };
}
template <class Change>
auto of_glass(Change change) {
    return where(true, false, change);
}
template <class Change>
auto of_opaque(Change change) {
    return where(false, true, change);
}

Statistic all_weights() {
    return formula<rt::whitted>(
        {.id = "W3",
         .what = "weights, off by",
         .tolerance = 1e-4,
         .right = [](const Material& m, double fresnel) { return weights(m, fresnel, is_glass(m)); },
         .suspects = {
             {"the mirrored ray of an opaque surface has weight 1: it must be attenuated by the reflectance",
              of_opaque([](Outgoing& o, const Material&, double) { o.mirror = Color(1); })},
             {"the mirrored ray has weight 1 where anything is reflected: it must be attenuated by the reflectance",
              of_opaque([](Outgoing& o, const Material&, double) {
                  if (o.mirror != Color(0)) o.mirror = Color(1);
              })},
             {"the mirrored ray has weight 1: it must be attenuated by the reflectance",
              where(true, true,
                    [](Outgoing& o, const Material& m, double f) { o.mirror = Color(is_glass(m) ? f : 1); })},
             {"the reflectance is missing from the mirrored ray of glass",
              of_glass([](Outgoing& o, const Material&, double f) { o.mirror = Color(f); })},
             {"Fresnel's share is missing from the mirrored ray of glass: R + T is not 1",
              of_glass([](Outgoing& o, const Material& m, double) { o.mirror = m.reflectance; })},
             {"the refracted ray carries the whole transmittance; expected the share 1 - fresnel: R + T is not 1",
              of_glass([](Outgoing& o, const Material& m, double) { o.glass = m.transmittance; })},
             {"Fresnel's share is not used", of_glass([](Outgoing& o, const Material& m, double) {
                  o.mirror = m.reflectance, o.glass = m.transmittance;
              })},
             {"fresnel and 1 - fresnel are exchanged",
              [](const Material& m, double f) { return weights(m, is_glass(m) ? 1 - f : f, is_glass(m)); }},
             {"an opaque mirror is attenuated by fresnel: that is for glass alone",
              of_opaque([](Outgoing& o, const Material&, double f) { o.mirror *= f; })},
             {"glass is told by one channel of its transmittance alone; expected any of them",
              [](const Material& m, double f) { return weights(m, f, m.transmittance.x > 0); }},
             {"the local light of glass is missing",
              of_glass([](Outgoing& o, const Material&, double) { o.local = Color(0); })},
             {"the local light is attenuated by what the mirror reflects; expected weight 1",
              of_opaque([](Outgoing& o, const Material& m, double) { o.local = Color(1) - m.reflectance; })},
             {"there is no mirrored ray",
              where(true, true, [](Outgoing& o, const Material&, double) { o.mirror = Color(0); })},
             {"there is no refracted ray",
              where(true, true, [](Outgoing& o, const Material&, double) { o.glass = Color(0); })}}});
}

}  // namespace

Checks check_whitted(Generator& random) {
    const auto any_weights = [](Generator& draw) {
        Material m = any_material(draw);
        m.albedo = box(draw, 0, 1);
        m.ior = chance(draw, 0.1) ? 1 : between(draw, 1.1, 2);
        m.reflectance = chance(draw, 0.7) ? box(draw, 0.2, 0.9) : Color(0);
        m.transmittance = Color(0);
        if (chance(draw, 0.6)) {
            m.transmittance = box(draw, 0.2, 0.9);
            // glass of one colour alone is still glass
            const int one = whole_between(draw, 0, 2);
            if (chance(draw, 0.4)) m.transmittance[(one + 1) % 3] = m.transmittance[(one + 2) % 3] = 0;
        }
        return row(m, between(draw, 0.05, 0.95));
    };
    // total reflection, none, and glass that hardly lets anything through
    const auto ends = [](Generator& draw) {
        Material m;
        m.ior = between(draw, 1.1, 2);
        m.reflectance = box(draw, 0.2, 0.9);
        m.transmittance[whole_between(draw, 0, 2)] = log_between(draw, 1e-4, 1);
        return row(m, chance(draw, 0.4) ? 1 : chance(draw, 0.3) ? 0 : between(draw, 0.05, 0.95));
    };
    // mirrors and glass of one colour or two; opaque surfaces have no share of Fresnel's, or any
    const auto channels = rows_of_channels(3, [](Generator& draw, int of, auto change) {
        constexpr int of_mirror = 0, of_glass = 1, of_transmittance = 2;
        Material m;
        m.ior = between(draw, 1.1, 2);
        m.reflectance = change(of == of_glass ? of_glass : of_mirror, box(draw, 0.2, 0.9));
        m.transmittance = of == of_mirror ? Color(0) : change(of_transmittance, box(draw, 0.2, 0.9));
        return row(m, chance(draw, 0.5) ? 0 : chance(draw, 0.3) ? 1 : log_between(draw, 1e-3, 1));
    });
    return {probe_check("weights", rows_then(rows_of_kinds(64, any_weights, ends), channels), {all_weights()}),
            invisible_glass(random)};
}

}  // namespace grade
