#include "diagnosis/rules/bounds.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/calls/scalars.h"

namespace grade {

namespace {

/// A number of an answer that must stay between two bounds.
class Bounds {
public:
    Bounds(const Calls& calls, const Ask& right) : calls_(calls) {
        const auto u = std::ranges::find(calls.layouts.front().parts, "u", &Field::name);
        if (u == calls.layouts.front().parts.end()) return;
        constexpr std::size_t most = 32, side = 4;
        const Rows answers =
            right(over_the_square(calls, std::size_t(u - calls.layouts.front().parts.begin()), most, side));
        const std::size_t bases = std::min(most, calls.size());
        for (std::size_t i = 0; i < answers.size(); ++i)
            more_.emplace_back(i / (side * side) * calls.size() / bases, answers[i]);
    }

    /// f(call, answer) of all right answers is within the bounds, and of one of mine it is not.
    template <class F>
    void look(const std::string& words, double low, double high, F f) {
        constexpr double room = 1e-4;
        double worst = room;
        std::size_t where = 0;
        std::vector<std::size_t> broken;
        for (const auto& [k, answer] : more_)
            if (is_void(calls_.result, answer))
                continue;
            else if (const double due = f(k, answer); !(due >= low - 1e-9) || !(due <= high + 1e-9))
                return;
        for (std::size_t k = 0; k < calls_.size(); ++k) {
            if (is_void(calls_.result, calls_.right[k]) || is_void(calls_.result, calls_.mine[k])) continue;
            const double due = f(k, calls_.right[k]), x = f(k, calls_.mine[k]);
            if (!(due >= low - 1e-9) || !(due <= high + 1e-9)) return;
            const double off = std::isnan(x) ? 0 : std::max(low - x, x - high);  // that is another mistake
            if (off > room) broken.push_back(k);
            if (off > worst) worst = off, where = k;
        }
        if (worst > room && !first) first = Broken{words, where, std::move(broken)};
    }

    bool is_sampled() const { return !more_.empty(); }

    std::optional<Broken> first;

private:
    const Calls& calls_;
    std::vector<std::pair<std::size_t, Row>> more_;  // right answers for other random numbers, by call
};

void look_at_vector(const Calls& calls, const Field& part, Bounds& bounds) {
    const auto vector = [at = part.at](const Row& answer) { return vector_at(answer, at); };
    bounds.look(name_of(part) + " must have length 1", 1, 1,
                [&](std::size_t, const Row& answer) { return glm::length(vector(answer)); });
    if (part.name != "direction") return;
    bounds.look(name_of(part) + " must point upwards: z must not be negative", 0, rt::inf,
                [&](std::size_t, const Row& answer) { return vector(answer).z; });
    const auto& parts = calls.layouts.front().parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (parts[i].kind != Kind::vector) continue;
        const auto along = [&, i](std::size_t k, const Row& answer) {
            return rt::dot(vector(answer), vector_at(calls.rows[k], calls.layouts[k].parts[i].at));
        };
        bounds.look(fmt::format("{} must be on the side of `{}`", name_of(part), parts[i].name), 0, rt::inf, along);
        bounds.look(fmt::format("{} must be on the other side than `{}`", name_of(part), parts[i].name), -rt::inf, 0,
                    along);
    }
}

}  // namespace

std::optional<Broken> broken_bound(const Calls& calls, const Ask& right) {
    Bounds bounds(calls, right);
    for (const Field& part : calls.result.parts) {
        if (part.kind == Kind::vector) look_at_vector(calls, part, bounds);
        if (part.kind == Kind::pair) {
            bounds.look(
                name_of(part) + " must be at most 1 from the middle", 0, 1,
                [&](std::size_t, const Row& answer) { return std::hypot(answer[part.at], answer[part.at + 1]); });
            for (std::size_t c = 0; c < 2; ++c)
                bounds.look(name_of(part) + " must be between 0 and 1 in both coordinates", 0, 1,
                            [&](std::size_t, const Row& answer) { return answer[part.at + c]; });
        }
        // a plain number may be negative elsewhere
        if (part.kind == Kind::number && (!part.name.empty() || bounds.is_sampled()))
            bounds.look(name_of(part) + " must not be negative", 0, rt::inf,
                        [&](std::size_t, const Row& answer) { return answer[part.at]; });
        for (std::size_t c = 0; part.kind == Kind::color && c < 3; ++c)
            bounds.look(name_of(part) + " must not be negative", 0, rt::inf,
                        [&](std::size_t, const Row& answer) { return answer[part.at + c]; });
    }
    return bounds.first;
}

namespace {

/// Whether each ray starts a little way from the point along a direction; point, along: in the arguments.
bool moves_along(const Calls& calls, std::size_t point, std::size_t origin, std::size_t along) {
    constexpr double little = 1e-3, parallel = 1e-2, rounding = 3 * rt::roundoff;
    std::size_t measured = 0;
    for (std::size_t k = 0; k < calls.size(); ++k) {
        const rt::vec3 from = vector_at(calls.rows[k], point), by = vector_at(calls.mine[k], origin) - from;
        const double way = glm::length(by), size = 1 + rt::largest(from);
        const bool is_rounded = way < 20 * rt::roundoff * size;  // then it has no direction
        if (way == 0 || way > little * size) return false;
        if (is_rounded) continue;
        const double beside = glm::length(rt::cross(by, vector_at(calls.rows[k], along)));
        if (beside > parallel * way + rounding * size) return false;
        ++measured;
    }
    return 2 * measured > calls.size();
}

}  // namespace

std::string starts_on_surface(const Calls& calls) {
    if (calls.size() == 0) return {};
    const auto named = [](const Layout& layout, const char* name) {
        const auto part = std::ranges::find(layout.parts, name, &Field::name);
        return part == layout.parts.end() ? std::nullopt : std::optional(part->at);
    };
    const auto point = named(calls.layouts.front(), "hit.point"), origin = named(calls.result, "origin"),
               near = named(calls.result, "near");
    if (!point || !origin || !near) return {};
    const auto to_light = named(calls.layouts.front(), "to_light");
    if (to_light && moves_along(calls, *point, *origin, *to_light))
        return "the origin is moved along `to_light`, by next to nothing off the surface where the light grazes it: "
               "`spawn_ray` moves it along the normal";
    bool is_epsilon = calls.mine.front()[*near] > 0;
    for (std::size_t k = 0; k < calls.size(); ++k) {
        const auto is_there = [&](const Row& answer) {
            return vector_at(answer, *origin) == vector_at(calls.rows[k], *point);
        };
        if (!is_there(calls.mine[k]) || is_there(calls.right[k])) return {};
        is_epsilon = is_epsilon && calls.mine[k][*near] == calls.mine.front()[*near];
    }
    return is_epsilon ? ""
                      : "the ray starts on the surface, which it can meet there: `spawn_ray` moves its origin off it";
}

}  // namespace grade
