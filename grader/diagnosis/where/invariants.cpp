#include "diagnosis/where/invariants.h"

#include "diagnosis/calls/scalars.h"

namespace grade {

using rt::vec3;

namespace {

vec3 at(const Row& row, const Field& part) { return vector_at(row, part.at); }

}  // namespace

Invariants::Invariants(const Calls& calls) : signature_(calls.signature) {
    const auto& parts = calls.layouts.front().parts;
    const auto all = [&](auto holds) {
        for (std::size_t k = 0; k < calls.size(); ++k)
            if (!holds(calls.rows[k], calls.layouts[k].parts)) return false;
        return true;
    };
    const auto matters = [&](std::size_t i) { return i >= calls.told.size() || calls.told[i]; };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!matters(i)) continue;
        for (std::size_t c = 0; c < size_of(parts[i].kind); ++c) {
            Range range{i, c, rt::inf, -rt::inf};
            for (std::size_t k = 0; k < calls.size(); ++k) {
                const double x = calls.rows[k][calls.layouts[k].parts[i].at + c];
                range.low = std::min(range.low, x), range.high = std::max(range.high, x);
            }
            if (parts[i].kind != Kind::vector) ranges_.push_back(range);
        }
        if (parts[i].kind != Kind::vector) continue;
        if (all([&](const Row& row, const auto& p) { return std::abs(glm::length(at(row, p[i])) - 1) < 1e-9; }))
            unit_.push_back(i);
        if (all([&](const Row& row, const auto& p) { return at(row, p[i]) != vec3(0); })) not_zero_.push_back(i);
        for (std::size_t j = 0; j < i; ++j)
            if (parts[j].kind == Kind::vector && matters(j)) {
                const auto is_right_angle = [&](const Row& row, const auto& p) {
                    const vec3 v = at(row, p[i]), w = at(row, p[j]);
                    return std::abs(rt::dot(v, w)) <= 1e-9 * glm::length(v) * glm::length(w);
                };
                if (all(is_right_angle)) right_angles_.emplace_back(i, j);
                for (const double sign : {1.0, -1.0})
                    if (all([&](const Row& row, const auto& p) {
                            return sign * rt::dot(at(row, p[i]), at(row, p[j])) > 0;
                        }))
                        sides_.push_back({i, j, sign});
                const auto is_same = [&](const Row& row, const auto& p) { return at(row, p[i]) == at(row, p[j]); };
                if (all(is_same)) same_.emplace_back(i, j);
            }
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (std::size_t j = 0; j < parts.size(); ++j)
            for (std::size_t c = 0; c < size_of(parts[i].kind); ++c)
                if (i != j && matters(i) && matters(j) && parts[i].kind == parts[j].kind &&
                    parts[i].kind != Kind::vector &&
                    all([&](const Row& row, const auto& p) { return row[p[i].at + c] <= row[p[j].at + c]; }))
                    ordered_.push_back({i, j, c, all([&](const Row& row, const auto& p) {
                                            return row[p[i].at + c] < row[p[j].at + c];
                                        })});
}

bool Invariants::mend(Row& row, std::size_t changed) const {
    const auto parts = signature_.of_arguments(row).parts;
    for (const auto& [i, j] : same_)
        if (changed == i || changed == j)
            for (std::size_t c = 0; c < 3; ++c) row[parts[changed == i ? j : i].at + c] = row[parts[changed].at + c];
    for (const Range& r : ranges_)
        if (const double x = row[parts[r.part].at + r.component]; !(x >= r.low && x <= r.high)) return false;
    for (const std::size_t i : unit_)
        if (std::abs(glm::length(at(row, parts[i])) - 1) > 1e-9) return false;
    for (const std::size_t i : not_zero_)
        if (at(row, parts[i]) == vec3(0)) return false;
    for (const auto& [i, j] : right_angles_) {
        const vec3 v = at(row, parts[i]), w = at(row, parts[j]);
        if (std::abs(rt::dot(v, w)) > 1e-9 * glm::length(v) * glm::length(w)) return false;
    }
    for (const auto& [i, j, sign] : sides_)
        if (!(sign * rt::dot(at(row, parts[i]), at(row, parts[j])) > 0)) return false;
    return std::ranges::all_of(ordered_, [&](const Ordered& o) {
        const double a = row[parts[o.a].at + o.component], b = row[parts[o.b].at + o.component];
        return o.strictly ? a < b : a <= b;
    });
}

}  // namespace grade
