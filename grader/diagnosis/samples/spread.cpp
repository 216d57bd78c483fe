#include "diagnosis/samples/spread.h"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/calls/scalars.h"
#include "diagnosis/changes/changes.h"

namespace grade {

namespace {

constexpr std::size_t side = 16;                      // squared: random numbers for each of the calls
constexpr std::size_t few_bases = 2, more_bases = 8;  // calls, with all of these: to find what to say, to check it
constexpr double as_good = 0.004;  // mean distance of two spreads that count as one, over their range
constexpr double dearest = 2;      // change that is tried

/// Numbers of an answer whose spread is looked at.
struct Projection {
    std::string words;
    std::function<double(const Row& row, const Row& answer)> value;
    std::string axis{};  // whose cosine with a direction it is
};

/// How a direction's cosine with an axis may be spread, by its quantiles.
struct Usual {
    const char* words;
    double (*quantile)(double);
};

constexpr Usual usual_spreads[] = {
    {"uniform on the whole sphere", [](double q) { return 2 * q - 1; }},
    {"uniform on the hemisphere about {}", [](double q) { return q; }},
    {"on the hemisphere about {}, with a density proportional to the cosine", [](double q) { return std::sqrt(q); }},
    {"on the hemisphere about {}, uniform in the angle", [](double q) { return std::sin(q * rt::pi / 2); }},
};

/// Of a point on a plane, where it is from one that is given; else how far out.
void add_pair(std::vector<Projection>& list, const std::string& name, std::size_t at, const std::vector<Field>& parts) {
    const auto from =
        std::ranges::find_if(parts, [](const Field& part) { return part.kind == Kind::pair && part.name != "u"; });
    const bool is_given = from != parts.end();
    if (!is_given)
        list.push_back(
            {"|" + name + "|", [at](const Row&, const Row& answer) { return std::hypot(answer[at], answer[at + 1]); }});
    for (std::size_t c = 0; c < 2; ++c)
        list.push_back(
            {fmt::format("{}.{}{}", name, "xy"[c], is_given ? fmt::format(" - {}.{}", from->name, "xy"[c]) : ""),
             [at, c, given = is_given ? std::optional(from->at) : std::nullopt](const Row& row, const Row& answer) {
                 return answer[at + c] - (given ? row[*given + c] : 0);
             }});
}

std::vector<Projection> projections(const Calls& calls) {
    std::vector<Projection> list;
    const auto& parts = calls.layouts.front().parts;
    for (const Field& part : calls.result.parts) {
        const std::string name = part.name.empty() ? "the answer" : part.name;
        const std::size_t at = part.at;
        if (part.kind == Kind::number || part.kind == Kind::color)
            list.push_back({part.kind == Kind::color ? name + ".x" : name,
                            [at](const Row&, const Row& answer) { return answer[at]; }});
        if (part.kind == Kind::pair) add_pair(list, name, at, parts);
        if (part.kind != Kind::vector) continue;
        std::vector<std::size_t> given;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i].kind == Kind::vector && calls.told[i]) given.push_back(i);
        const auto along = [&](const std::string& axis, auto at_row) {
            list.push_back(
                {fmt::format("dot({}, {})", axis, name),
                 [=](const Row& row, const Row& answer) { return rt::dot(at_row(row), vector_at(answer, at)); },
                 part.name == "direction" ? axis : ""});
        };
        for (const std::size_t i : given)
            along(parts[i].name, [from = parts[i].at](const Row& row) { return vector_at(row, from); });
        for (const std::size_t i : given)
            for (const std::size_t j : given)
                if (i < j)
                    along(fmt::format("({} mirrored at {})", parts[i].name, parts[j].name),
                          [from = parts[i].at, to = parts[j].at](const Row& row) {
                              const rt::vec3 d = vector_at(row, from), n = vector_at(row, to);
                              return d - 2 * rt::dot(d, n) * n;
                          });
        for (std::size_t c = 0; given.empty() && c < 3; ++c)
            list.push_back({fmt::format("{}.{}", name, "xyz"[c]),
                            [at, c](const Row&, const Row& answer) { return answer[at + c]; },
                            c == 2 && part.name == "direction" ? "the z axis" : ""});
    }
    return list;
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

/// Whether numbers are spread so: in steps as a grid has them, or evenly.
bool is_spread(const std::vector<double>& x, const Usual& as) {
    std::vector<double> steps, even;
    for (std::size_t i = 0; i < x.size(); ++i) {
        steps.push_back(as.quantile((double(i / side) + 0.5) / (double(x.size()) / double(side))));
        even.push_back(as.quantile((double(i) + 0.5) / double(x.size())));
    }
    // evenly as far as so many points can be
    return apart(x, steps) <= as_good || apart(x, even) <= 5 * as_good;
}

/// A usual spread of directions that all calls have, and that the right ones do not have; empty: none.
std::string usual_spread(const Spreads& own, const Spreads& due, const std::vector<Projection>& list) {
    for (const Usual& usual : usual_spreads)
        for (std::size_t p = 0; p < list.size(); ++p) {
            bool is_so = !list[p].axis.empty(), is_right = true;
            for (std::size_t i = p; is_so && i < own.size(); i += list.size())
                is_so = is_spread(own[i], usual), is_right = is_right && is_spread(due[i], usual);
            const bool is_axis = list[p].axis.find(' ') == std::string::npos;
            if (is_so && !is_right)
                return fmt::format(fmt::runtime(usual.words), is_axis ? "`" + list[p].axis + "`" : list[p].axis);
        }
    return {};
}

/// The step of which all numbers are multiples, where there are few of them; 0: there is none.
double step_of(const std::vector<double>& x) {
    double step = rt::inf;
    std::size_t values = 1;
    for (std::size_t i = 1; i < x.size(); ++i)
        if (const double gap = x[i] - x[i - 1]; gap > 1e-9 * std::abs(x[i])) step = std::min(step, gap), ++values;
    const auto is_multiple = [&](double v) { return std::abs(v / step - std::round(v / step)) < 1e-6; };
    return values >= 3 && 4 * values < 3 * x.size() && std::ranges::all_of(x, is_multiple) ? step : 0;
}

/// That a number comes in steps, of which each is a constant times or over an argument; empty: it does not, or the
/// right one does as well.
std::string in_steps(const Calls& calls, const Spreads& own, const Spreads& due, const Rows& rows,
                     const std::vector<Projection>& list) {
    const auto all = scalars_of(calls.layouts.front(), calls.told);
    for (std::size_t p = 0; p < list.size(); ++p)
        for (const Scalar& s : all)
            for (const int power : {0, 1, -1}) {
                double constant = 0;
                bool is_so = true;
                for (std::size_t i = p; is_so && i < own.size(); i += list.size()) {
                    const Row& row = rows[i / list.size() * side * side];
                    const double factor = std::pow(row[s.at(calls.layouts.front())], power);
                    const double step = step_of(own[i]) / factor;
                    is_so = step > 0 && step_of(due[i]) == 0 && (constant == 0 || std::abs(step / constant - 1) < 1e-6);
                    constant = step;
                }
                if (!is_so || constant == 0) continue;
                const std::string words = number_in_words(constant);
                return fmt::format(
                    "{} is always a whole multiple of `{}`; expected any value in between as well: smaller steps are "
                    "steps too",
                    list[p].words, power == 0 ? words : words + (power > 0 ? " * " : " / ") + s.name);
            }
    return {};
}

/// How many of sorted numbers differ.
std::size_t different(const std::vector<double>& x) {
    const double apart = 1e-9 * std::max(std::abs(x.front()), std::abs(x.back()));
    std::size_t count = 1;
    for (std::size_t i = 1; i < x.size(); ++i) count += x[i] - x[i - 1] > apart;
    return count;
}

/// That a number has few values, at most so many, where the right one has many; empty: it has not.
std::string in_few_values(const Spreads& own, const Spreads& due, const std::vector<Projection>& list,
                          std::size_t few) {
    constexpr std::size_t many_times = 4;
    for (std::size_t p = 0; p < list.size(); ++p) {
        std::size_t most = 0;
        bool is_so = p < own.size();
        for (std::size_t i = p; is_so && i < own.size(); i += list.size()) {
            const std::size_t count = different(own[i]);
            is_so = count > 1 && count <= few && many_times * count <= different(due[i]);
            most = std::max(most, count);
        }
        if (is_so)
            return fmt::format(
                "for {} random numbers {} has {} different values at most: it must have a new one for each",
                side * side, list[p].words, most);
    }
    return {};
}

double mean_of(const std::vector<double>& sorted) {
    double sum = 0;
    for (const double v : sorted) sum += v;
    const double mean = sum / double(sorted.size());
    return std::abs(mean) < 1e-9 * (sorted.back() - sorted.front()) ? 0 : mean;
}

/// "1.2 on average; it must be 1.4", and the ranges where means are nearly the same.
std::string means_in_words(const std::vector<double>& mine, const std::vector<double>& right) {
    const double own = mean_of(mine), due = mean_of(right);
    constexpr double clear = 0.02;
    if (std::abs(own - due) > clear * (right.back() - right.front()))
        return fmt::format("{:.4g} on average; it must be {:.4g}", own, due);
    return fmt::format("{:.4g} on average, from {:.4g} to {:.4g}; it must be {:.4g}, from {:.4g} to {:.4g}", own,
                       mine.front(), mine.back(), due, right.front(), right.back());
}

/// Which argument the random numbers are; none: there are none.
std::optional<std::size_t> numbers_of(const Calls& calls) {
    if (calls.size() == 0) return std::nullopt;
    const auto& parts = calls.layouts.front().parts;
    const auto u = std::ranges::find(parts, "u", &Field::name);
    return u == parts.end() ? std::nullopt : std::optional(std::size_t(u - parts.begin()));
}

}  // namespace

std::string coarse_spread(const Calls& calls, const Ask& mine, const Ask& right) {
    const auto numbers = numbers_of(calls);
    if (!numbers) return {};
    const std::vector<Projection> list = projections(calls);
    const Rows rows = over_the_square(calls, *numbers, few_bases, side);
    const Spreads own = spreads(rows, mine(rows), list), due = spreads(rows, right(rows), list);
    if (own.empty() || due.empty()) return {};
    if (std::string steps = in_steps(calls, own, due, rows, list); !steps.empty()) return steps;
    // what depends on one of two numbers has as many values as the grid has columns
    const bool are_two = calls.layouts.front().parts[*numbers].kind == Kind::pair;
    return in_few_values(own, due, list, (are_two ? side : side * side) / 2);
}

std::optional<std::string> spread_of(const Calls& calls, const Calls& all, const Ask& mine, const Ask& right) {
    const auto given = numbers_of(calls);
    if (!given) return std::nullopt;
    const std::size_t numbers = *given;
    const std::vector<Projection> list = projections(calls);
    const Rows rows = over_the_square(calls, numbers, few_bases, side),
               more = over_the_square(all, numbers, more_bases, side);
    const Spreads own = spreads(rows, mine(rows), list), due = spreads(rows, right(rows), list);
    if (own.empty() || due.empty()) return std::nullopt;
    if (most_apart(own, due) <= as_good) return std::nullopt;
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
    const std::string so = usual_spread(own, due, list);
    return fmt::format("{}over all random numbers {} is {}", so.empty() ? so : "the directions are " + so + ": ",
                       list[worst % list.size()].words, means_in_words(own[worst], due[worst]));
}

}  // namespace grade
