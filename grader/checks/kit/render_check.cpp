#include "checks/kit/render_check.h"

#include <fmt/format.h>

namespace grade {

Check render_check(std::string name, Render render, std::vector<Statistic> statistics) {
    return {std::move(name), {}, std::move(render), std::move(statistics)};
}

Statistic of_picture(const Picture& p) {
    return {.id = p.id,
            .what = p.what,
            .measure = [number = p.number](const Observation& seen) { return number(seen.image); },
            .truth = p.truth,
            .delta0 = p.delta0.value_or(p.delta / 10),
            .delta = p.delta,
            .exact = p.exact,
            .hint = p.hint,
            .cause = p.cause};
}

Statistic rays_of_kind(std::string id, rt::RayKind kind, double truth, double delta, Hint hint) {
    return {.id = std::move(id),
            .what = fmt::format("{} rays for each of the camera", rt::ray_kind_names[std::size_t(kind)]),
            .measure =
                [kind](const Observation& seen) {
                    return seen.rays.at(std::size_t(kind)) / seen.rays.at(std::size_t(rt::RayKind::camera));
                },
            .truth = truth,
            .delta0 = delta / 10,
            .delta = delta,
            .hint = std::move(hint)};
}

std::vector<Statistic> rgb(const std::function<Statistic(int channel, const std::string& name)>& of_channel) {
    return {of_channel(0, "red"), of_channel(1, "green"), of_channel(2, "blue")};
}

}  // namespace grade
