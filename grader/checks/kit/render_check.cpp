#include "checks/kit/render_check.h"

#include <array>

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

std::vector<Statistic> rgb(const std::function<Statistic(int channel, const std::string& name)>& of_channel) {
    return {of_channel(0, "red"), of_channel(1, "green"), of_channel(2, "blue")};
}

}  // namespace grade
