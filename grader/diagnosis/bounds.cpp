#include "diagnosis/bounds.h"

#include <fmt/format.h>

#include "diagnosis/scalars.h"

namespace grade {

namespace {

/// A number of an answer that must stay between two bounds.
class Bounds {
public:
    explicit Bounds(const Calls& calls) : calls_(calls) {}

    /// f(call, answer) of all right answers is within the bounds, and of one of mine it is not.
    template <class F>
    void look(const std::string& words, double low, double high, F f) {
        constexpr double room = 1e-4;
        double worst = room;
        std::size_t where = 0;
        for (std::size_t k = 0; k < calls_.size(); ++k) {
            const double due = f(k, calls_.right[k]), x = f(k, calls_.mine[k]);
            if (!(due >= low - 1e-9) || !(due <= high + 1e-9)) return;
            const double off = std::isnan(x) ? 0 : std::max(low - x, x - high);  // that is another mistake
            if (off > worst) worst = off, where = k;
        }
        if (worst > room && !first) first = Broken{words, where};
    }

    std::optional<Broken> first;

private:
    const Calls& calls_;
};

std::string name_of(const Field& part) { return part.name.empty() ? "the answer" : "`" + part.name + "`"; }

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

std::optional<Broken> broken_bound(const Calls& calls) {
    Bounds bounds(calls);
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
        if (part.kind == Kind::number)
            bounds.look(name_of(part) + " must not be negative", 0, rt::inf,
                        [&](std::size_t, const Row& answer) { return answer[part.at]; });
        for (std::size_t c = 0; part.kind == Kind::color && c < 3; ++c)
            bounds.look(name_of(part) + " must not be negative", 0, rt::inf,
                        [&](std::size_t, const Row& answer) { return answer[part.at + c]; });
    }
    return bounds.first;
}

}  // namespace grade
