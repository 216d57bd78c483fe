#include "diagnosis/calls/calls_made.h"

#include <fmt/format.h>

#include "diagnosis/calls/scalars.h"

namespace grade {

Ask limited(const Ask& ask, std::size_t& left) {
    return [&ask, &left](const Rows& rows) -> Rows {
        if (rows.size() > left) return {};
        left -= rows.size();
        Rows answers = ask(rows);
        return answers.size() == rows.size() ? answers : Rows{};
    };
}

Calls only_wrong(const Calls& all) {
    return those_of(all, [&](std::size_t k) { return all.is_wrong(k); });
}

Calls only_nan(Calls calls) {
    for (std::size_t k = 0; k < calls.size(); ++k)
        if (!is_nan(calls.mine[k], calls.right[k])) calls.mine[k] = calls.right[k];
    return calls;
}

Calls picked(const Calls& all, std::size_t most, bool others) {
    std::vector<std::size_t> wrong, good;
    for (std::size_t k = 0; k < all.size(); ++k) (all.is_wrong(k) ? wrong : good).push_back(k);
    const auto thin = [others](std::vector<std::size_t> from, std::size_t count) {
        if (from.size() <= count) return from;
        std::vector<std::size_t> some;
        for (std::size_t i = 0; i < count; ++i) some.push_back(from[(2 * i + others) * from.size() / (2 * count)]);
        return some;
    };
    const std::size_t of_right = std::min(good.size(), most - std::min(wrong.size(), most * 2 / 3));
    std::vector<std::size_t> chosen = thin(wrong, most - of_right);
    for (const std::size_t k : thin(good, of_right)) chosen.push_back(k);
    return those_of(all, [&](std::size_t k) { return std::ranges::count(chosen, k) > 0; });
}

std::vector<Dependence> dependences(const Calls& asked, const Calls& others, const Ask& mine, const Ask& right) {
    constexpr std::size_t most = 64;
    const std::size_t count = std::min(asked.size(), most);
    const auto& parts = asked.layouts.front().parts;
    std::vector<Dependence> all(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Rows rows;
        for (std::size_t k = 0; k < count; ++k) {
            Row row = asked.rows[k];
            const std::size_t other = (k * 7 + 3) % others.size();
            for (std::size_t c = 0; c < size_of(parts[i].kind); ++c)
                row[asked.layouts[k].parts[i].at + c] = others.rows[other][others.layouts[other].parts[i].at + c];
            rows.push_back(std::move(row));
        }
        const auto differs = [&](const Rows& answers, const Rows& before) {
            double changed = 0;
            for (std::size_t k = 0; k < answers.size(); ++k) changed += !is_equal(asked.result, answers[k], before[k]);
            return answers.empty() ? 1 : changed / double(answers.size());
        };
        all[i] = {differs(mine(rows), asked.mine), differs(right(rows), asked.right)};
    }
    return all;
}

Calls compared(const Signature& signature, const Rows& rows, const Ask& mine, const Ask& right) {
    Calls calls{signature, {}, {}, {}, {}, {}, {}};
    const Rows own = mine(rows), solution = right(rows);
    if (own.size() != rows.size() || solution.size() != rows.size()) return calls;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (own[k].size() != solution[k].size()) continue;
        calls.rows.push_back(rows[k]), calls.mine.push_back(own[k]), calls.right.push_back(solution[k]);
        calls.layouts.push_back(signature.of_arguments(rows[k]));
    }
    if (calls.size() > 0) calls.result = signature.of_result(calls.right.front());
    return calls;
}

namespace {

/// The calls, and others of which the solution's answers are numbers.
Calls with_rows(const Calls& calls, const Rows& rows, const Ask& mine, const Ask& right) {
    Calls all = calls, more = compared(calls.signature, rows, mine, right);
    for (std::size_t k = 0; k < more.size(); ++k) {
        if (std::ranges::any_of(more.right[k], [](double x) { return std::isnan(x); })) continue;
        all.rows.push_back(more.rows[k]), all.layouts.push_back(more.layouts[k]);
        all.mine.push_back(more.mine[k]), all.right.push_back(more.right[k]);
    }
    return all;
}

}  // namespace

Calls crossed(const Calls& calls, const Ask& mine, const Ask& right) {
    constexpr std::size_t most = 96;
    std::vector<std::size_t> numbers;
    const auto& parts = calls.layouts.front().parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (calls.told[i] && (parts[i].kind == Kind::number || parts[i].kind == Kind::pair)) numbers.push_back(i);
    constexpr std::size_t few = 16;
    const std::vector<std::size_t> wrong = calls.wrong();
    const bool is_rare = !wrong.empty() && wrong.size() < few;
    Rows rows;
    for (std::size_t k = 0; k < std::min(most, calls.size()) && !numbers.empty(); ++k) {
        const std::size_t from = is_rare && k % 2 ? wrong[k / 2 % wrong.size()]
                                                  : k * calls.size() / std::min(most, calls.size()),
                          other = (from * 5 + 11 + (is_rare ? k : 0)) % calls.size();
        const std::size_t i = numbers[k % numbers.size()];
        Row row = calls.rows[from];
        for (std::size_t c = 0; c < size_of(parts[i].kind); ++c)
            row[calls.layouts[from].parts[i].at + c] = calls.rows[other][calls.layouts[other].parts[i].at + c];
        rows.push_back(std::move(row));
    }
    return with_rows(calls, rows, mine, right);
}

namespace {

/// A point near a shape, given in its edges and its normal, or in a sphere's radius.
rt::vec3 near_shape(const Row& row, const Layout& layout, rt::vec3 at) {
    std::vector<rt::vec3> shape;
    for (const Field& part : layout.parts)
        if (part.kind == Kind::vector && !part.name.starts_with("ray.")) shape.push_back(vector_at(row, part.at));
    if (shape.size() < 3) return shape.front() + row[layout.parts[1].at] * at;
    const bool are_corners = layout.parts.front().name.ends_with(".a");
    const rt::vec3 from = are_corners ? shape[0] : rt::vec3(0), u = shape[1] - from, v = shape[2] - from;
    return shape[0] + at.x * u + at.y * v + 0.3 * at.z * glm::length(u) * rt::unit(rt::cross(u, v));
}

}  // namespace

Calls near_shapes(const Calls& calls, const Ask& mine, const Ask& right) {
    constexpr std::size_t most = 96;
    const auto& parts = calls.layouts.front().parts;
    const auto find = [&](const char* name) { return std::ranges::find(parts, name, &Field::name); };
    const auto origin = find("ray.origin"), near = find("ray.near"), far = find("ray.far");
    if (origin == parts.end() || near == parts.end() || far == parts.end()) return calls;
    Rows rows;
    for (std::size_t k = 0; k < most; ++k) {
        Row row = calls.rows[k * calls.size() / most];
        const auto between = [k](double low, double high, double step) {
            return low + (high - low) * (double(k) * step - std::floor(double(k) * step));
        };
        put(row, origin->at,
            near_shape(row, calls.layouts.front(),
                       {between(-1.2, 1.2, 0.618034), between(-1.2, 1.2, 0.754878), between(-1, 1, 0.569840)}));
        row[near->at] = -rt::inf, row[far->at] = rt::inf;
        rows.push_back(std::move(row));
    }
    return with_rows(calls, rows, mine, right);
}

Rows over_the_square(const Calls& calls, std::size_t u, std::size_t most, std::size_t side) {
    Rows rows;
    const std::size_t bases = std::min(most, calls.size());
    const auto middle = [](std::size_t i, std::size_t count) { return (double(i) + 0.5) / double(count); };
    for (std::size_t base = 0; base < bases; ++base)
        for (std::size_t i = 0; i < side * side; ++i) {
            const std::size_t k = base * calls.size() / bases;
            rows.push_back(calls.rows[k]);
            const Field& numbers = calls.layouts[k].parts[u];
            const bool are_two = numbers.kind == Kind::pair;
            rows.back()[numbers.at] = are_two ? middle(i % side, side) : middle(i, side * side);
            if (are_two) rows.back()[numbers.at + 1] = middle(i / side, side);
        }
    return rows;
}

namespace {

/// Nothing where something must be, and something where nothing must be, each time.
std::string inverted(const Calls& calls) {
    constexpr std::ptrdiff_t least = 8;
    const Field& part = calls.result.parts.front();
    for (const double nothing : {rt::inf, 0.0}) {
        std::ptrdiff_t lost = 0, added = 0, both = 0;
        for (std::size_t k = 0; k < calls.size(); ++k) {
            const bool mine = calls.mine[k][part.at] == nothing, right = calls.right[k][part.at] == nothing;
            lost += mine && !right, added += !mine && right, both += !mine && !right;
        }
        if (part.kind == Kind::number && lost >= least && added >= least && both == 0)
            return fmt::format(
                "{} is {} wherever it must not be, and is not where it must be: is a test the wrong way round?",
                name_of(part), number_in_words(nothing));
    }
    return {};
}

}  // namespace

std::string usual_wrong_answer(const Calls& calls) {
    if (const std::string words = inverted(calls); !words.empty()) return words;
    constexpr double nearly = 0.8;
    if (calls.result.parts.front().kind == Kind::flag) return {};
    const std::vector<std::size_t> wrong = calls.wrong();
    for (std::size_t i = 0; i < std::min<std::size_t>(wrong.size(), 4); ++i) {
        const auto same = std::ranges::count_if(
            wrong, [&](std::size_t k) { return is_equal(calls.result, calls.mine[k], calls.mine[wrong[i]]); });
        if (wrong.size() >= 8 && double(same) >= nearly * double(wrong.size()))
            return fmt::format("the answer is {} in {} of {} wrong calls",
                               result_in_words(calls.signature, calls.mine[wrong[i]]), same, wrong.size());
    }
    const auto too_many = std::ranges::count_if(
        wrong, [&](std::size_t k) { return calls.right[k] == Row{rt::inf} && is_something(calls.mine[k]); });
    if (wrong.size() >= 8 && double(too_many) >= nearly * double(wrong.size()))
        return fmt::format("in {} of {} wrong calls the right answer is inf: these must be turned away", too_many,
                           wrong.size());
    return {};
}

std::string independence(const Calls& calls, const std::vector<Dependence>& all) {
    if (auto words = usual_wrong_answer(calls); !words.empty()) return words;
    constexpr double often = 0.2;  // what changes a few answers may be chance
    std::string lost, added;
    const auto& parts = calls.layouts.front().parts;
    const auto tell = [](std::string& list, const std::string& name) {
        list += (list.empty() ? "`" : ", `") + name + "`";
    };
    // of two arguments that are one, either may be used
    const auto has_twin = [&](std::size_t i) {
        for (std::size_t j = 0; j < parts.size(); ++j) {
            std::size_t k = 0;
            const auto same = [&] {
                const double *a = &calls.rows[k][calls.layouts[k].parts[i].at],
                             *b = &calls.rows[k][calls.layouts[k].parts[j].at];
                return std::equal(a, a + size_of(parts[i].kind), b);
            };
            if (i == j || parts[i].kind != Kind::vector || parts[j].kind != Kind::vector) continue;
            while (k < calls.size() && same()) ++k;
            if (k == calls.size()) return true;
        }
        return false;
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (all[i].right > often && all[i].mine == 0 && !has_twin(i)) tell(lost, parts[i].name);
        if (all[i].mine > often && all[i].right == 0 && !has_twin(i)) tell(added, parts[i].name);
    }
    if (!lost.empty()) return fmt::format("the answer is the same whatever {} is", lost);
    if (!added.empty()) return fmt::format("the answer depends on {}, which must not matter", added);
    return {};
}

std::string unused_numbers(const Calls& calls, const std::vector<Dependence>& all) {
    const auto& parts = calls.layouts.front().parts;
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (parts[i].name == "u" && all[i].right > 0 && all[i].mine == 0)
            return "the answer is the same whatever `u` is";
    return {};
}

Calls with_parts_that_matter(Calls all, const Ask& mine, const Ask& right) {
    const Calls wrong = only_wrong(all);
    if (wrong.size() == 0) return all;
    const auto depends = dependences(wrong, all, mine, right);
    for (std::size_t i = 0; i < depends.size(); ++i)
        all.told[i] = all.told[i] && (depends[i].mine > 0 || depends[i].right > 0);
    return all;
}

}  // namespace grade
