#include "diagnosis/samples/own_numbers.h"

#include "rt/math.h"

namespace grade {

namespace {

using rt::vec2;

/// A call with other random numbers.
Row with(const Calls& calls, std::size_t k, std::size_t part, vec2 u) {
    Row row = calls.rows[k];
    const std::size_t at = calls.layouts[k].parts[part].at;
    row[at] = std::clamp(u.x, 0.0, rt::below_one), row[at + 1] = std::clamp(u.y, 0.0, rt::below_one);
    return row;
}

/// By call, those random numbers with which the solution's place is nearest to mine: the best of a grid, then of finer
/// ones about it.
std::vector<vec2> nearest_numbers(const Calls& calls, const Ask& right, std::size_t part, const Field& place) {
    constexpr int rounds = 24, first_side = 16, side = 5;
    std::vector<vec2> best(calls.size(), vec2(0.5));
    double width = 1;
    for (int round = 0; round < rounds; ++round) {
        const int count = round == 0 ? first_side : side;
        const auto tried = [&](std::size_t k, int i) {
            return best[k] + width * ((vec2(i % count, i / count) + 0.5) / double(count) - vec2(0.5));
        };
        Rows rows;
        for (std::size_t k = 0; k < calls.size(); ++k)
            for (int i = 0; i < count * count; ++i) rows.push_back(with(calls, k, part, tried(k, i)));
        const Rows answers = right(rows);
        if (answers.size() != rows.size()) return {};
        for (std::size_t k = 0; k < calls.size(); ++k) {
            double least = rt::inf;
            int nearest = 0;
            for (int i = 0; i < count * count; ++i) {
                double off = 0;
                for (std::size_t c = 0; c < size_of(place.kind); ++c)
                    off += rt::sqr(answers[k * std::size_t(count * count) + std::size_t(i)][place.at + c] -
                                   calls.mine[k][place.at + c]);
                if (off < least) least = off, nearest = i;
            }
            best[k] = glm::clamp(tried(k, nearest), vec2(0), vec2(1));
        }
        width *= round == 0 ? 4.0 / first_side : 0.5;
    }
    return best;
}

/// Which argument u is, and which part of an answer a place that can be looked for; none: there is no such part.
struct PlaceOfNumbers {
    std::size_t u;
    Field place;
};

std::optional<PlaceOfNumbers> place_of_numbers(const Calls& calls) {
    const auto& parts = calls.layouts.front().parts;
    const auto u = std::ranges::find(parts, "u", &Field::name);
    const auto place = std::ranges::find_if(calls.result.parts, is_place);
    if (u == parts.end() || u->kind != Kind::pair || place == calls.result.parts.end()) return std::nullopt;
    if (calls.result.parts.size() < 2) return std::nullopt;
    return PlaceOfNumbers{std::size_t(u - parts.begin()), *place};
}

constexpr double near = 1e-6;  // places that count as one

}  // namespace

std::optional<Calls> with_own_numbers(const Calls& calls, const Ask& right) {
    constexpr std::size_t most = 48, least = 10;
    constexpr double many = 0.6;
    const auto at = place_of_numbers(calls);
    if (!at) return std::nullopt;
    const std::size_t step = std::max<std::size_t>(calls.size() / most, 1);
    const Calls some = those_of(calls, [&](std::size_t k) {
        return k % step == 0 && k / step < most && !is_void(calls.result, calls.right[k]);
    });
    const auto numbers = nearest_numbers(some, right, at->u, at->place);
    if (numbers.size() != some.size() || some.size() < least) return std::nullopt;
    Calls own = some;
    for (std::size_t k = 0; k < some.size(); ++k) own.rows[k] = with(some, k, at->u, numbers[k]);
    own.right = right(own.rows);
    if (own.right.size() != own.rows.size()) return std::nullopt;
    own = those_of(own, [&](std::size_t k) { return is_equal(at->place, own.right[k], own.mine[k], near); });
    const bool is_enough = own.size() >= least && double(own.size()) >= many * double(some.size());
    return is_enough ? std::optional(std::move(own)) : std::nullopt;
}

Ask at_own_places(const Calls& like, const Ask& mine, const Ask& right) {
    return [&like, mine, right](const Rows& rows) {
        Rows answers = right(rows);
        const auto at = place_of_numbers(like);
        Calls calls{like.signature, rows, mine(rows), answers, {}, like.result, like.told};
        calls.layouts.assign(rows.size(), like.layouts.front());
        if (!at || calls.mine.size() != rows.size() || answers.size() != rows.size()) return answers;
        const auto numbers = nearest_numbers(calls, right, at->u, at->place);
        if (numbers.size() != rows.size()) return answers;
        Rows own = rows;
        for (std::size_t k = 0; k < rows.size(); ++k) own[k] = with(calls, k, at->u, numbers[k]);
        const Rows there = right(own);
        for (std::size_t k = 0; k < there.size(); ++k)
            if (is_equal(at->place, there[k], calls.mine[k], near)) answers[k] = there[k];
        return answers;
    };
}

}  // namespace grade
