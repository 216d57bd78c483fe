#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/kit/glass.h"
#include "checks/kit/probe_check.h"

namespace grade {

namespace {

using rt::Color, rt::Material, rt::Outgoing;

RowFunction weights(std::function<Outgoing(const Material&, double fresnel, bool glass)> f) {
    return of<Material, double>(
        [=](const Material& m, double fresnel) { return f(m, fresnel, m.transmittance != Color(0)); });
}

}  // namespace

Checks check_whitted(Generator& random) {
    const auto inputs = rows_of(64, [](Generator& draw) {
        Material m;
        m.albedo = box(draw, 0, 1);
        m.ior = between(draw, 1.1, 2);
        if (chance(draw, 0.7)) m.reflectance = box(draw, 0.2, 0.9);
        if (chance(draw, 0.6)) {
            m.transmittance = box(draw, 0.2, 0.9);
            // glass of one colour alone is still glass
            const int one = whole_between(draw, 0, 2);
            if (chance(draw, 0.4)) m.transmittance[(one + 1) % 3] = m.transmittance[(one + 2) % 3] = 0;
        }
        return row(m, between(draw, 0.05, 0.95));
    });
    const auto right = weights([](const Material& m, double fresnel, bool glass) {
        return glass ? Outgoing{Color(1), fresnel * m.reflectance, (1 - fresnel) * m.transmittance}
                     : Outgoing{Color(1), m.reflectance, Color(0)};
    });
    const std::vector<Suspect> suspects = {
        {"the mirrored ray of an opaque surface has weight 1: it must be attenuated by the reflectance",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), f * m.reflectance, (1 - f) * m.transmittance}
                          : Outgoing{Color(1), Color(1), Color(0)};
         })},
        {"the mirrored ray has weight 1 where anything is reflected: it must be attenuated by the reflectance",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), f * m.reflectance, (1 - f) * m.transmittance}
                          : Outgoing{Color(1), m.reflectance == Color(0) ? Color(0) : Color(1), Color(0)};
         })},
        {"the mirrored ray has weight 1: it must be attenuated by the reflectance",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), Color(f), (1 - f) * m.transmittance}
                          : Outgoing{Color(1), Color(1), Color(0)};
         })},
        {"the reflectance is missing from the mirrored ray of glass",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), Color(f), (1 - f) * m.transmittance}
                          : Outgoing{Color(1), m.reflectance, Color(0)};
         })},
        {"Fresnel's share is missing from the mirrored ray of glass: R + T is not 1",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), m.reflectance, (1 - f) * m.transmittance}
                          : Outgoing{Color(1), m.reflectance, Color(0)};
         })},
        {"the refracted ray carries the whole transmittance; expected the share 1 - fresnel: R + T is not 1",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), f * m.reflectance, m.transmittance}
                          : Outgoing{Color(1), m.reflectance, Color(0)};
         })},
        {"Fresnel's share is not used", weights([](const Material& m, double, bool glass) {
             return glass ? Outgoing{Color(1), m.reflectance, m.transmittance}
                          : Outgoing{Color(1), m.reflectance, Color(0)};
         })},
        {"fresnel and 1 - fresnel are exchanged", weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), (1 - f) * m.reflectance, f * m.transmittance}
                          : Outgoing{Color(1), m.reflectance, Color(0)};
         })},
        {"an opaque mirror is attenuated by fresnel: that is for glass alone",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), f * m.reflectance, (1 - f) * m.transmittance}
                          : Outgoing{Color(1), f * m.reflectance, Color(0)};
         })},
        {"glass is told by one channel of its transmittance alone; expected any of them",
         weights([](const Material& m, double f, bool) {
             return m.transmittance.x > 0 ? Outgoing{Color(1), f * m.reflectance, (1 - f) * m.transmittance}
                                          : Outgoing{Color(1), m.reflectance, Color(0)};
         })},
        {"the local light of glass is missing", weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(0), f * m.reflectance, (1 - f) * m.transmittance}
                          : Outgoing{Color(1), m.reflectance, Color(0)};
         })},
        {"the local light is attenuated by what the mirror reflects; expected weight 1",
         weights([](const Material& m, double f, bool glass) {
             return glass ? Outgoing{Color(1), f * m.reflectance, (1 - f) * m.transmittance}
                          : Outgoing{Color(1) - m.reflectance, m.reflectance, Color(0)};
         })},
        {"there is no mirrored ray", weights([](const Material& m, double f, bool glass) {
             return Outgoing{Color(1), Color(0), glass ? (1 - f) * m.transmittance : Color(0)};
         })},
        {"there is no refracted ray", weights([](const Material& m, double f, bool glass) {
             return Outgoing{Color(1), (glass ? f : 1) * m.reflectance, Color(0)};
         })}};
    return {probe_check("weights", inputs, {formula("W3", "weights, off by", right, 1e-4, suspects)}),
            invisible_glass(random)};
}

}  // namespace grade
