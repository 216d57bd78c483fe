#include "diagnosis/own_numbers.h"

#include <array>

#include "rt/math.h"

namespace grade {

namespace {

using rt::vec2;

/// The solution's places for many pairs of random numbers, and how far they are from mine.
class Places {
public:
    Places(const Calls& calls, const Ask& right, std::size_t numbers, const Field& place)
        : calls_(calls), right_(right), numbers_(numbers), place_(place) {}

    Row with(std::size_t k, vec2 u) const {
        Row row = calls_.rows[k];
        const std::size_t at = calls_.layouts[k].parts[numbers_].at;
        row[at] = std::clamp(u.x, 0.0, rt::below_one), row[at + 1] = std::clamp(u.y, 0.0, rt::below_one);
        return row;
    }

    /// By call and trial, the way from mine to the solution's place; none: it gave no answer.
    std::optional<std::vector<Rows>> ways(const std::vector<std::vector<vec2>>& trials) const {
        Rows rows;
        for (std::size_t k = 0; k < trials.size(); ++k)
            for (const vec2 u : trials[k]) rows.push_back(with(k, u));
        const Rows answers = right_(rows);
        if (answers.size() != rows.size()) return std::nullopt;
        std::vector<Rows> all;
        for (std::size_t k = 0, i = 0; k < trials.size(); ++k) {
            all.emplace_back();
            for (std::size_t j = 0; j < trials[k].size(); ++j, ++i) {
                all[k].emplace_back();
                for (std::size_t c = 0; c < size_of(place_.kind); ++c)
                    all[k].back().push_back(answers[i][place_.at + c] - calls_.mine[k][place_.at + c]);
            }
        }
        return all;
    }

private:
    const Calls& calls_;
    const Ask& right_;
    std::size_t numbers_;
    Field place_;
};

double product(const Row& v, const Row& w) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += v[i] * w[i];
    return sum;
}

std::size_t nearest(const Rows& ways) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < ways.size(); ++i)
        if (!(product(ways[best], ways[best]) <= product(ways[i], ways[i]))) best = i;
    return best;
}

/// The step that Gauss and Newton would make from a way, with the ways a little to each side: of u.x, of u.y.
vec2 step_from(const Row& way, const std::array<Row, 4>& beside, double apart) {
    Row x, y;
    for (std::size_t c = 0; c < way.size(); ++c)
        x.push_back((beside[1][c] - beside[0][c]) / apart), y.push_back((beside[3][c] - beside[2][c]) / apart);
    const double xx = product(x, x), xy = product(x, y), yy = product(y, y), all = xx * yy - xy * xy;
    const double to_x = product(x, way), to_y = product(y, way);
    return all > 0 ? vec2(xy * to_y - yy * to_x, xy * to_x - xx * to_y) / all : vec2(0);
}

/// The numbers with which the solution comes nearest, by call.
std::optional<std::vector<vec2>> nearest_numbers(const Places& places, std::size_t count) {
    constexpr int side = 12, rounds = 10;
    constexpr double beside = 1e-6;
    std::vector<std::vector<vec2>> trials(count);
    for (auto& all : trials)
        for (int i = 0; i < side * side; ++i) all.push_back((vec2(i % side, i / side) + 0.5) / double(side));
    std::vector<vec2> best(count);
    for (int round = 0; round <= rounds; ++round) {
        const auto ways = places.ways(trials);
        if (!ways) return std::nullopt;
        for (std::size_t k = 0; k < count; ++k) {
            best[k] = glm::clamp(trials[k][nearest((*ways)[k])], vec2(beside), vec2(1 - beside));
            trials[k] = {best[k], best[k] - vec2(beside, 0), best[k] + vec2(beside, 0), best[k] - vec2(0, beside),
                         best[k] + vec2(0, beside)};
        }
        const auto around = places.ways(trials);
        if (!around) return std::nullopt;
        for (std::size_t k = 0; k < count; ++k) {
            const Rows& way = (*around)[k];
            const vec2 step = step_from(way[0], {way[1], way[2], way[3], way[4]}, 2 * beside);
            trials[k] = {best[k], best[k] + step, best[k] + 0.5 * step, best[k] + 0.1 * step};
        }
    }
    return best;
}

}  // namespace

std::optional<Calls> with_own_numbers(const Calls& calls, const Ask& right) {
    constexpr std::size_t most = 48, least = 10;
    constexpr double near = 1e-6, many = 0.6;
    const auto& parts = calls.layouts.front().parts;
    const auto u = std::ranges::find(parts, "u", &Field::name);
    const auto place = std::ranges::find_if(calls.result.parts, is_place);
    if (u == parts.end() || u->kind != Kind::pair || place == calls.result.parts.end()) return std::nullopt;
    if (calls.result.parts.size() < 2) return std::nullopt;
    Calls some = calls;
    for (auto* list : {&some.rows, &some.mine, &some.right}) list->clear();
    some.layouts.clear();
    for (std::size_t i = 0; i < std::min(most, calls.size()); ++i) {
        const std::size_t k = i * calls.size() / std::min(most, calls.size());
        if (is_void(calls.result, calls.right[k])) continue;
        some.rows.push_back(calls.rows[k]), some.layouts.push_back(calls.layouts[k]);
        some.mine.push_back(calls.mine[k]), some.right.push_back(calls.right[k]);
    }
    if (some.size() < least) return std::nullopt;
    const Places places(some, right, std::size_t(u - parts.begin()), *place);
    const auto numbers = nearest_numbers(places, some.size());
    if (!numbers) return std::nullopt;
    Rows rows;
    for (std::size_t k = 0; k < some.size(); ++k) rows.push_back(places.with(k, (*numbers)[k]));
    const Rows answers = right(rows);
    if (answers.size() != rows.size()) return std::nullopt;
    Calls own = some;
    for (auto* list : {&own.rows, &own.mine, &own.right}) list->clear();
    own.layouts.clear();
    for (std::size_t k = 0; k < some.size(); ++k) {
        if (!is_equal(*place, answers[k], some.mine[k], near)) continue;
        own.rows.push_back(rows[k]), own.layouts.push_back(some.layouts[k]);
        own.mine.push_back(some.mine[k]), own.right.push_back(answers[k]);
    }
    const bool is_enough = own.size() >= least && double(own.size()) >= many * double(some.size());
    return is_enough ? std::optional(std::move(own)) : std::nullopt;
}

}  // namespace grade
