#include "diagnosis/changes/changes_made.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/calls/expressions.h"
#include "diagnosis/calls/quantities.h"
#include "textbook/functions.h"

namespace grade {

namespace {

/// A whole number that a fragment can be given.
bool fits(double& x, double before, bool whole) {
    if (!whole) return true;
    if (!(std::abs(x) < 1e6)) return false;
    x = std::floor(x);
    return before <= 0 || x > 0 || before == 1;
}

}  // namespace

Changes::Changes(const Layout& layout, const std::vector<bool>& told)
    : layout_(layout), told_(told), scalars_(scalars_of(layout, told)) {
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        if (!is_told(i)) continue;
        if (layout.parts[i].kind == Kind::vector) vectors_.push_back(i);
        if (layout.parts[i].kind == Kind::color) colors_.push_back(i);
        if (layout.parts[i].kind == Kind::flag) add_flag(i);
    }
    for (const Scalar& s : scalars_) add_scalar(s);
    for (const std::size_t i : vectors_) add_vector(i, vectors_, vector_functions, of_two_vectors);
    for (const std::size_t i : colors_) add_vector(i, colors_, color_functions, of_two_colors);
    for (const std::size_t i : vectors_) add_scaled(i, 2.2);
    for (const std::size_t i : colors_) add_scaled(i, 1.9);
    add_joint();
    add_pairs();
    add_lists();
    std::ranges::stable_sort(all_, {}, &Change::cost);
}

void Changes::add_flag(std::size_t i) {
    add("!" + name(i), name(i), 1, [i](Row& row, const Layout& l) {
        row[l.parts[i].at] = 1 - row[l.parts[i].at];
        return true;
    });
    for (const double value : {0.0, 1.0})
        add(value != 0 ? "true" : "false", name(i), 1.1, [i, value](Row& row, const Layout& l) {
            row[l.parts[i].at] = value;
            return true;
        });
}

void Changes::add_scalar(const Scalar& s) {
    for (const Function& f : scalar_functions) {
        const bool of_index = s.whole && s.name == "i", is_half = std::string(f.words) == "{} / 2";
        // whole numbers are rarely rounded by mistake
        if (constexpr double some = 3; s.whole && !is_half && f.value(some) != std::floor(f.value(some))) continue;
        add(s.whole && is_half ? s.name + " / 2 (of whole numbers)" : filled(f.words, s.name), s.name, f.cost,
            [s, f, of_index](Row& row, const Layout& l) {
                double& x = row[s.at(l)];
                const double before = x;
                x = f.value(x);
                if (of_index && !(x >= 0)) return false;
                return fits(x, of_index ? 0 : before, s.whole);
            });
        all_.back().usually = f.usually;
    }
    for (const Scalar& other : scalars_) {
        if (other.name == s.name || s.whole != other.whole) continue;
        const double near = s.owner() == other.owner() ? -0.3 : 0;
        for (const TwoScalars& f : of_two_scalars)
            add(filled(f.words, s.name, other.name), s.name, f.cost + near, [s, other, f](Row& row, const Layout& l) {
                double& x = row[s.at(l)];
                const double before = x;
                x = f.value(x, row[other.at(l)]);
                return fits(x, before, s.whole);
            });
        if (s.owner() == "u" && other.owner() == "u")
            all_[all_.size() - std::size(of_two_scalars)].usually = ": one number is used for both";
        if (s.name < other.name)
            add(fmt::format("`{}` and `{}` exchanged", s.name, other.name), 1.1, [s, other](Row& row, const Layout& l) {
                std::swap(row[s.at(l)], row[other.at(l)]);
                return true;
            });
        if (!s.whole && s.owner() != "u")
            add(fmt::format("`{0}` and `{1}` exchanged where `{0} > {1}`", s.name, other.name), 1.4,
                [s, other](Row& row, const Layout& l) {
                    if (row[s.at(l)] > row[other.at(l)]) std::swap(row[s.at(l)], row[other.at(l)]);
                    return true;
                });
    }
}

template <class Functions, class TwoFunctions>
void Changes::add_vector(std::size_t i, const std::vector<std::size_t>& others, const Functions& functions,
                         const TwoFunctions& of_two) {
    for (const VectorFunction& f : functions)
        add(filled(f.words, name(i)), name(i), f.cost, [i, f](Row& row, const Layout& l) {
            put(row, l.parts[i].at, f.value(vector_at(row, l.parts[i].at)));
            return true;
        });
    for (const std::size_t j : others) {
        if (j == i) continue;
        for (const TwoVectors& f : of_two)
            add(filled(f.words, name(i), name(j)), name(i), f.cost, [i, j, f](Row& row, const Layout& l) {
                put(row, l.parts[i].at, f.value(vector_at(row, l.parts[i].at), vector_at(row, l.parts[j].at)));
                return true;
            });
        if (i < j)
            add(fmt::format("`{}` and `{}` exchanged", name(i), name(j)), 1.1, [i, j](Row& row, const Layout& l) {
                const vec3 v = vector_at(row, l.parts[i].at), w = vector_at(row, l.parts[j].at);
                put(row, l.parts[i].at, w), put(row, l.parts[j].at, v);
                return true;
            });
    }
}

void Changes::add_scaled(std::size_t i, double cost) {
    const auto factor = [&](const std::string& words, double more,
                            std::function<double(const Row&, const Layout&)> value) {
        add(fmt::format("{} * {}", name(i), words), name(i), cost + more, [i, value](Row& row, const Layout& l) {
            const double x = value(row, l);
            put(row, l.parts[i].at, x * vector_at(row, l.parts[i].at));
            return std::isfinite(x);
        });
    };
    std::vector<Quantity> list;
    const bool is_color = layout_.parts[i].kind == Kind::color;
    for (const Scalar& s : scalars_)
        list.push_back({s.name, [s](const Row& row, const Layout& l, const Row&) { return row[s.at(l)]; }});
    for (std::size_t a = 0; is_color && a < vectors_.size(); ++a)
        for (std::size_t b = a + 1; b < vectors_.size(); ++b)
            list.push_back({fmt::format("dot({}, {})", name(vectors_[a]), name(vectors_[b])),
                            [v = vectors_[a], w = vectors_[b]](const Row& row, const Layout& l, const Row&) {
                                return rt::dot(vector_at(row, l.parts[v].at), vector_at(row, l.parts[w].at));
                            }});
    for (std::size_t a = 0; a < list.size(); ++a) {
        const auto p = list[a].value;
        factor(list[a].words, 0, [p](const Row& row, const Layout& l) { return p(row, l, {}); });
        factor("1 / " + list[a].words, 0, [p](const Row& row, const Layout& l) { return 1 / p(row, l, {}); });
        for (std::size_t b = 0; b < list.size(); ++b) {
            if (a == b) continue;
            const auto q = list[b].value;
            const std::string ratio = fmt::format("{} / {}", list[a].words, list[b].words);
            factor(ratio, 0.4, [p, q](const Row& row, const Layout& l) { return p(row, l, {}) / q(row, l, {}); });
            if (!is_color)
                factor(fmt::format("({})^2", ratio), 0.6,
                       [p, q](const Row& row, const Layout& l) { return rt::sqr(p(row, l, {}) / q(row, l, {})); });
        }
    }
}

std::vector<Change> changes_of(const Layout& layout, const std::vector<bool>& told) {
    return Changes(layout, told).take();
}

std::vector<Change> same_sampling(const Layout& layout) {
    std::vector<Change> all{{"", 0, [](Row&, const Layout&) { return true; }, {}}};
    const auto part = std::ranges::find(layout.parts, "u", &Field::name);
    if (part == layout.parts.end()) return all;
    const std::size_t i = std::size_t(part - layout.parts.begin());
    const bool two = part->kind == Kind::pair, has_index = std::ranges::count(layout.parts, "i", &Field::name) > 0;
    for (int flips = 1; flips < (two ? 8 : 2); ++flips)
        all.push_back({"", 0.1 * flips, [i, flips](Row& row, const Layout& l) {
                           double* u = &row[l.parts[i].at];
                           if (flips & 1) u[0] = 1 - u[0];
                           if (flips & 2) u[1] = 1 - u[1];
                           if (flips & 4) std::swap(u[0], u[1]);
                           return true;
                       }});
    if (has_index) all.resize(1);  // where in a cell, not where in the square
    return all;
}

}  // namespace grade
