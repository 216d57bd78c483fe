#include "diagnosis/calls/directions.h"

#include <fmt/format.h>

#include "diagnosis/calls/scalars.h"

namespace grade {

std::vector<Direction> directions_of(const Calls& calls, const std::vector<bool>& told) {
    constexpr std::size_t most = 4;
    const auto& parts = calls.layouts.front().parts;
    std::vector<Direction> all;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        bool is_unit = parts[i].kind == Kind::vector && told[i];
        for (std::size_t k = 0; is_unit && k < calls.size(); ++k)
            is_unit = std::abs(glm::length(vector_at(calls.rows[k], calls.layouts[k].parts[i].at)) - 1) < 1e-6;
        if (!is_unit) continue;
        const auto value = [i](const Row& row, const Layout& l) { return vector_at(row, l.parts[i].at); };
        all.push_back({fmt::format("`{}`", parts[i].name), parts[i].name, {i}, value});
    }
    if (all.size() > most) return {};
    const std::vector<Direction> plain = all;
    for (const Direction& n : plain)
        for (const Direction& d : plain) {
            if (d.parts == n.parts) continue;
            const auto value = [n = n.value, d = d.value](const Row& row, const Layout& l) {
                const rt::vec3 normal = n(row, l), other = d(row, l);
                return 2 * rt::dot(normal, other) * normal - other;
            };
            all.push_back({fmt::format("{} mirrored at {}", d.words, n.words),
                           fmt::format("2 * dot({0}, {1}) * {0} - {1}", n.code, d.code),
                           {d.parts.front(), n.parts.front()},
                           value});
        }
    return all;
}

}  // namespace grade
