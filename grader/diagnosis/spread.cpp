#include "diagnosis/spread.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/changes.h"
#include "diagnosis/scalars.h"

namespace grade {

namespace {

constexpr int side = 16;                              // squared: random numbers for each of the calls
constexpr std::size_t few_bases = 2, more_bases = 8;  // calls, with all of these: to find what to say, to check it
constexpr double as_good = 0.004;  // mean distance of two spreads that count as one, over their range
constexpr double dearest = 2;      // change that is tried

/// Numbers of an answer whose spread is looked at.
struct Projection {
    std::string words;
    std::function<double(const Row& row, const Row& answer)> value;
};

std::vector<Projection> projections(const Calls& calls) {
    std::vector<Projection> list;
    const auto& parts = calls.layouts.front().parts;
    for (const Field& part : calls.result.parts) {
        const std::string name = part.name.empty() ? "the answer" : part.name;
        const std::size_t at = part.at;
        if (part.kind == Kind::number || part.kind == Kind::color)
            list.push_back({part.kind == Kind::color ? name + ".x" : name,
                            [at](const Row&, const Row& answer) { return answer[at]; }});
        if (part.kind == Kind::pair)
            list.push_back({"|" + name + "|",
                            [at](const Row&, const Row& answer) { return std::hypot(answer[at], answer[at + 1]); }});
        if (part.kind != Kind::vector) continue;
        std::size_t given = 0;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].kind == Kind::vector && calls.told[i]) {
                ++given;
                list.push_back({fmt::format("dot({}, {})", parts[i].name, name),
                                [at, from = parts[i].at](const Row& row, const Row& answer) {
                                    return rt::dot(vector_at(row, from), vector_at(answer, at));
                                }});
            }
        for (std::size_t c = 0; given == 0 && c < 3; ++c)
            list.push_back({fmt::format("{}.{}", name, "xyz"[c]),
                            [at, c](const Row&, const Row& answer) { return answer[at + c]; }});
    }
    return list;
}

/// Some of the calls, each with random numbers from all over the square.
Rows over_the_square(const Calls& calls, const Field& u, std::size_t most) {
    Rows rows;
    const std::size_t bases = std::min(most, calls.size());
    for (std::size_t b = 0; b < bases; ++b)
        for (int i = 0; i < side * side; ++i) {
            Row row = calls.rows[b * calls.size() / bases];
            row[u.at] = u.kind == Kind::pair ? (i % side + 0.5) / side : (i + 0.5) / (side * side);
            if (u.kind == Kind::pair) row[u.at + 1] = (i / side + 0.5) / side;
            rows.push_back(std::move(row));
        }
    return rows;
}

/// By base and projection: sorted numbers.
using Spreads = std::vector<std::vector<double>>;

Spreads spreads(const Rows& rows, const Rows& answers, const std::vector<Projection>& list) {
    Spreads all;
    if (answers.size() != rows.size()) return all;
    for (std::size_t start = 0; start < rows.size(); start += side * side)
        for (const Projection& projection : list) {
            std::vector<double> x;
            for (std::size_t i = start; i < start + side * side; ++i)
                x.push_back(projection.value(rows[i], answers[i]));
            if (!std::ranges::all_of(x, [](double v) { return std::isfinite(v); })) x.assign(x.size(), 1e300);
            std::ranges::sort(x);
            all.push_back(std::move(x));
        }
    return all;
}

/// Their mean distance, over the range of both.
double apart(const std::vector<double>& x, const std::vector<double>& y) {
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += std::abs(x[i] - y[i]);
    const double low = std::min(x.front(), y.front()), high = std::max(x.back(), y.back());
    // what rounding does is no range
    const double range = std::max(high - low, 1e-6 * std::max(std::abs(low), std::abs(high)));
    return sum == 0 ? 0 : sum / double(x.size()) / range;
}

double most_apart(const Spreads& a, const Spreads& b) {
    if (a.size() != b.size()) return 1;
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, apart(a[i], b[i]));
    return most;
}

std::string mean_and_range(const std::vector<double>& x) {
    double sum = 0;
    for (const double v : x) sum += v;
    const double mean = sum / double(x.size());
    const bool is_zero = std::abs(mean) < 1e-9 * (x.back() - x.front());
    return fmt::format("{:.4g} on average, from {:.4g} to {:.4g}", is_zero ? 0.0 : mean, x.front(), x.back());
}

}  // namespace

std::optional<std::string> spread_of(const Calls& calls, const Calls& all, const Ask& mine, const Ask& right) {
    const auto& parts = calls.layouts.front().parts;
    const auto u = std::ranges::find(parts, "u", &Field::name);
    if (u == parts.end() || calls.size() == 0) return std::nullopt;
    const std::vector<Projection> list = projections(calls);
    const Rows rows = over_the_square(calls, *u, few_bases), more = over_the_square(all, *u, more_bases);
    const Spreads own = spreads(rows, mine(rows), list), due = spreads(rows, right(rows), list);
    if (own.empty() || due.empty() || most_apart(own, due) <= as_good) return std::nullopt;
    Spreads own_more;
    const auto is_alike = [&](const Change& change, Rows changed, const Spreads& wanted) {
        const Rows before = changed;
        const bool made = std::ranges::all_of(changed, [&](Row& row) {
            return change.make(row, calls.layouts.front()) && row.size() == before[0].size();
        });
        // the projections of the call as it was
        return made && most_apart(wanted, spreads(before, right(changed), list)) <= as_good;
    };
    for (const Change& change : changes_of(calls.layouts.front(), calls.told)) {
        if (change.cost > dearest) break;
        if (!is_alike(change, rows, own)) continue;
        if (own_more.empty()) own_more = spreads(more, mine(more), list);
        if (is_alike(change, more, own_more))
            return "the answers are spread as those of the right fragment with " + change.words + change.usually;
    }
    std::size_t worst = 0;
    for (std::size_t i = 0; i < own.size(); ++i)
        if (apart(own[i], due[i]) > apart(own[worst], due[worst])) worst = i;
    if (own[worst].back() == 1e300) return std::nullopt;
    return fmt::format("over all random numbers {} is {}; it must be {}", list[worst % list.size()].words,
                       mean_and_range(own[worst]), mean_and_range(due[worst]));
}

}  // namespace grade
