#include "checks/light_sample/checks.h"
#include "statistics/regression.h"

namespace grade::light_sample {

namespace {

using rt::Emitter, rt::LightSample, rt::vec2, rt::vec3;

constexpr int layout_count = 48, samples_of_each = 16;

/// The powers of distance, cosine and area that the estimates of small lights at many places have left over; nan where
/// there is no light.
double leftover_power(const Observation& seen, std::size_t which) {
    std::vector<std::vector<double>> factors;
    std::vector<double> logs;
    for (int k = 0; k < layout_count; ++k) {
        double sum = 0;
        for (int i = 0; i < samples_of_each; ++i) {
            const LightSample s = result<rt::light_sample>(seen.outputs[k * samples_of_each + i]);
            if (s.density > 0) sum += 1 / s.density / samples_of_each;
        }
        const Row& in = seen.inputs[k * samples_of_each];
        const Emitter light = argument<rt::light_sample, 0>(in);
        const vec3 to = light.quad.center - argument<rt::light_sample, 1>(in);
        const double r = glm::length(to), cosine = -rt::dot(to, rt::unit(rt::normal(light))) / r;
        factors.push_back({1, std::log(r), std::log(cosine), std::log(rt::area(light))});
        logs.push_back(std::log(sum * r * r / (cosine * rt::area(light))));
        if (!std::isfinite(logs.back())) return NAN;
    }
    return least_squares(factors, logs)[which];
}

}  // namespace

Check many_places() {
    const auto inputs = [](Generator& random) {
        Rows rows;
        for (int k = 0; k < layout_count; ++k) {
            Emitter light = emitter(random, Emitter::Kind::quad);
            light.quad.u *= 0.3, light.quad.v *= 0.3;
            const double angle = between(random, 0, 1.2);
            const vec3 p =
                light.quad.center + log_between(random, 1.5, 8) * tilted(random, rt::unit(rt::normal(light)), angle);
            for (int i = 0; i < samples_of_each; ++i) rows.push_back(row(light, p, square(random)));
        }
        return rows;
    };
    const auto power = [](std::size_t which, const std::string& of, const std::vector<KnownValue>& known,
                          const std::string& else_words) {
        return Statistic{.id = "L2",
                         .what = "power of the " + of + " that is left over",
                         .measure = [=](const Observation& seen) { return leftover_power(seen, which); },
                         .truth = 0,
                         .delta0 = 0.02,
                         .delta = 0.3,
                         .hint = [=](double value, double) -> std::string {
                             if (std::isnan(value)) return "the light gives no light where it must";
                             for (const KnownValue& k : known)
                                 if (std::abs(value - k.value) < 0.3) return k.words;
                             return else_words;
                         }};
    };
    return probe_check(
        "many_places", inputs,
        {power(1, "distance",
               {{2, "1/r^2 is missing: density per solid angle = density per area * distance^2 / cosine"},
                {1, "the distance counts once; expected squared"}},
               "the estimate has a wrong power of the distance"),
         power(2, "cosine at the light",
               {{-1,
                 "the cosine at the light is missing: density per solid angle = density per area * distance^2 / "
                 "cosine"}},
               "the cosine at the light has a wrong power: is the density multiplied where it must be divided?"),
         power(3, "area", {{-1, "the area is missing: the density per area is 1 / area"}},
               "the estimate has a wrong power of the light's area")});
}

}  // namespace grade::light_sample
