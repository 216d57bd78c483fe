#include "diagnosis/changes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rt/math.h"

namespace grade {

namespace {

using rt::vec3;

vec3 vector_at(const Row& row, std::size_t at) { return {row[at], row[at + 1], row[at + 2]}; }
void put(Row& row, std::size_t at, vec3 v) { row[at] = v.x, row[at + 1] = v.y, row[at + 2] = v.z; }

/// A number of an argument.
struct Scalar {
    std::string name;
    std::size_t part, component;
    bool whole;

    std::size_t at(const Layout& layout) const { return layout.parts[part].at + component; }
    std::string owner() const { return name.substr(0, name.rfind('.')); }
};

std::vector<Scalar> scalars_of(const Layout& layout, const std::vector<bool>& told) {
    std::vector<Scalar> list;
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        const auto& [name, kind, at] = layout.parts[i];
        if (i < told.size() && !told[i]) continue;
        const bool whole = kind == Kind::whole || kind == Kind::whole_pair;
        if (kind == Kind::number || kind == Kind::whole) list.push_back({name, i, 0, whole});
        if (kind == Kind::pair || kind == Kind::whole_pair)
            list.push_back({name + ".x", i, 0, whole}), list.push_back({name + ".y", i, 1, whole});
    }
    return list;
}

struct Function {
    const char* words;  // {} is the argument
    double cost;
    double (*value)(double);
    const char* usually = "";  // what that is in most code
};

constexpr Function scalar_functions[] = {
    {"-{}", 1, [](double x) { return -x; }},
    {"2 * {}", 1.1, [](double x) { return 2 * x; }},
    {"{} / 2", 1.1, [](double x) { return x / 2; }},
    {"{0} * {0}", 1.2, [](double x) { return x * x; }, ": is a square root missing?"},
    {"sqrt({})", 1.2, [](double x) { return std::sqrt(x); }, ": is a square root too many?"},
    {"1 / {}", 1.2, [](double x) { return 1 / x; }},
    {"1 - {}", 1.2, [](double x) { return 1 - x; }},
    {"{} + 1", 1.2, [](double x) { return x + 1; }},
    {"{} - 1", 1.2, [](double x) { return x - 1; }},
    {"abs({})", 1.2, [](double x) { return std::abs(x); }},
    {"max({}, 0)", 1.3, [](double x) { return std::max(x, 0.0); }},
    {"min({}, 1)", 1.3, [](double x) { return std::min(x, 1.0); }},
    {"0", 1.3, [](double) { return 0.0; }},
    {"1", 1.3, [](double) { return 1.0; }},
    {"0.5", 1.4, [](double) { return 0.5; }},
    {"inf", 1.4, [](double) { return rt::inf; }},
    {"{} * 180 / pi", 1.5, [](double x) { return x * 180 / rt::pi; }, ": angles are in radians"},
    {"{} * pi / 180", 1.5, [](double x) { return x * rt::pi / 180; }, ": it is in radians already"},
    {"tan({})", 1.5, [](double x) { return std::tan(x); }},
    {"atan({})", 1.6, [](double x) { return std::atan(x); }},
    {"sin({})", 1.6, [](double x) { return std::sin(x); }},
    {"cos({})", 1.6, [](double x) { return std::cos(x); }},
    {"asin({})", 1.6, [](double x) { return std::asin(x); }},
    {"{} / (2 * pi)", 1.5, [](double x) { return x / (2 * rt::pi); }},
    {"2 * pi * {}", 1.5, [](double x) { return 2 * rt::pi * x; }},
    {"{} / pi", 1.6, [](double x) { return x / rt::pi; }},
    {"pi * {}", 1.6, [](double x) { return x * rt::pi; }},
    {"{} / 4", 1.7, [](double x) { return x / 4; }},
    {"4 * {}", 1.7, [](double x) { return 4 * x; }},
    {"3 * {} / 4", 1.9, [](double x) { return 0.75 * x; }},
    {"floor({})", 1.6, [](double x) { return std::floor(x); }},
    {"round({})", 1.6, [](double x) { return std::round(x); }},
    {"{} + 0.5", 1.6, [](double x) { return x + 0.5; }},
    {"{} - 0.5", 1.6, [](double x) { return x - 0.5; }},
    {"{} + 2", 1.7, [](double x) { return x + 2; }},
    {"{} - 2", 1.7, [](double x) { return x - 2; }},
    {"2 * {} - 1", 1.7, [](double x) { return 2 * x - 1; }},
    {"sqrt(sqrt({}))", 1.9, [](double x) { return std::sqrt(std::sqrt(x)); }},
    {"sqrt(1 - {0} * {0})", 1.8, [](double x) { return std::sqrt(1 - x * x); }},
    {"1 - {0} * {0}", 1.9, [](double x) { return 1 - x * x; }},
    {"cbrt({})", 1.8, [](double x) { return std::cbrt(x); }},
    {"pow({}, 2.0 / 3)", 1.9, [](double x) { return std::pow(x, 2.0 / 3); }},
    {"pow({}, 3)", 1.9, [](double x) { return x * x * x; }},
    {"pow({}, 1.5)", 2, [](double x) { return std::pow(x, 1.5); }},
    {"pow({}, 4)", 2, [](double x) { return x * x * x * x; }},
    {"{0} / (1 - {0})", 2.2, [](double x) { return x / (1 - x); }},
};

struct TwoScalars {
    const char* words;
    double cost;
    double (*value)(double, double);
};

constexpr TwoScalars of_two_scalars[] = {
    {"{1}", 1.5, [](double, double y) { return y; }},
    {"{0} * {1}", 1.9, [](double x, double y) { return x * y; }},
    {"{0} / {1}", 1.9, [](double x, double y) { return x / y; }},
    {"{1} / {0}", 2, [](double x, double y) { return y / x; }},
    {"{0} - {1}", 1.9, [](double x, double y) { return x - y; }},
    {"{0} + {1}", 1.9, [](double x, double y) { return x + y; }},
    {"1 - {1}", 1.9, [](double, double y) { return 1 - y; }},
    {"max({0}, {1})", 2.1, [](double x, double y) { return std::max(x, y); }},
    {"min({0}, {1})", 2.1, [](double x, double y) { return std::min(x, y); }},
};

struct VectorFunction {
    const char* words;
    double cost;
    vec3 (*value)(vec3);
};

double length(vec3 v) { return std::sqrt(rt::dot(v, v)); }

constexpr VectorFunction vector_functions[] = {
    {"-{}", 1, [](vec3 v) { return -v; }},
    {"unit({})", 1.1, [](vec3 v) { return rt::unit(v); }},
    {"2 * {}", 1.2, [](vec3 v) { return 2.0 * v; }},
    {"{} / 2", 1.2, [](vec3 v) { return 0.5 * v; }},
    {"(0, 0, 0)", 1.4, [](vec3) { return vec3(0); }},
    {"(0, 0, 1)", 1.4, [](vec3) { return vec3(0, 0, 1); }},
    {"(0, 1, 0)", 1.4, [](vec3) { return vec3(0, 1, 0); }},
    {"(1, 0, 0)", 1.5, [](vec3) { return vec3(1, 0, 0); }},
    {"{0} / |{0}|^2", 1.8, [](vec3 v) { return v / rt::dot(v, v); }},
    {"{0} * |{0}|", 1.8, [](vec3 v) { return v * length(v); }},
    {"{0} with x and y exchanged", 1.5, [](vec3 v) { return vec3(v.y, v.x, v.z); }},
    {"{0} with y and z exchanged", 1.5, [](vec3 v) { return vec3(v.x, v.z, v.y); }},
    {"{0} with x and z exchanged", 1.6, [](vec3 v) { return vec3(v.z, v.y, v.x); }},
    {"{0} with x = 0", 1.5, [](vec3 v) { return vec3(0, v.y, v.z); }},
    {"{0} with y = 0", 1.5, [](vec3 v) { return vec3(v.x, 0, v.z); }},
    {"{0} with z = 0", 1.5, [](vec3 v) { return vec3(v.x, v.y, 0); }},
    {"{0} with x negated", 1.6, [](vec3 v) { return vec3(-v.x, v.y, v.z); }},
    {"{0} with y negated", 1.6, [](vec3 v) { return vec3(v.x, -v.y, v.z); }},
    {"{0} with z negated", 1.6, [](vec3 v) { return vec3(v.x, v.y, -v.z); }},
    {"(|x|, |y|, |z|) of {0}", 1.8, [](vec3 v) { return glm::abs(v); }},
};

constexpr VectorFunction color_functions[] = {
    {"{} / pi", 1.1, [](vec3 c) { return c / rt::pi; }},
    {"pi * {}", 1.1, [](vec3 c) { return c * rt::pi; }},
    {"2 * {}", 1.2, [](vec3 c) { return 2.0 * c; }},
    {"{} / 2", 1.2, [](vec3 c) { return 0.5 * c; }},
    {"{0} * {0}", 1.2, [](vec3 c) { return c * c; }},
    {"sqrt({})", 1.3, [](vec3 c) { return glm::sqrt(c); }},
    {"(0, 0, 0)", 1.2, [](vec3) { return vec3(0); }},
    {"(1, 1, 1)", 1.3, [](vec3) { return vec3(1); }},
    {"1 - {}", 1.4, [](vec3 c) { return 1.0 - c; }},
    {"min({}, 1)", 1.3, [](vec3 c) { return glm::min(c, vec3(1)); }},
    {"{0}.x in all channels", 1.3, [](vec3 c) { return vec3(c.x); }},
    {"{0}.y in all channels", 1.4, [](vec3 c) { return vec3(c.y); }},
    {"{0}.z in all channels", 1.4, [](vec3 c) { return vec3(c.z); }},
    {"{0} with red and green exchanged", 1.4, [](vec3 c) { return vec3(c.y, c.x, c.z); }},
    {"{0} with green and blue exchanged", 1.4, [](vec3 c) { return vec3(c.x, c.z, c.y); }},
    {"{0} with red and blue exchanged", 1.4, [](vec3 c) { return vec3(c.z, c.y, c.x); }},
    {"the mean of {}'s channels", 1.5, [](vec3 c) { return vec3((c.x + c.y + c.z) / 3); }},
    {"pow({}, 1 / 2.2)", 1.7, [](vec3 c) { return glm::pow(c, vec3(1 / 2.2)); }},
    {"pow({}, 2.2)", 1.7, [](vec3 c) { return glm::pow(c, vec3(2.2)); }},
};

struct TwoVectors {
    const char* words;
    double cost;
    vec3 (*value)(vec3, vec3);
};

constexpr TwoVectors of_two_vectors[] = {
    {"{1}", 1.4, [](vec3, vec3 w) { return w; }},
    {"-{1}", 1.6, [](vec3, vec3 w) { return -w; }},
    {"{0} + {1}", 1.7, [](vec3 v, vec3 w) { return v + w; }},
    {"{0} - {1}", 1.7, [](vec3 v, vec3 w) { return v - w; }},
    {"unit({0} + {1})", 1.7, [](vec3 v, vec3 w) { return rt::unit(v + w); }},
    {"2 * dot({0}, {1}) * {1} - {0}", 1.7, [](vec3 v, vec3 w) { return 2 * rt::dot(v, w) * w - v; }},
    {"{0} - 2 * dot({0}, {1}) * {1}", 1.8, [](vec3 v, vec3 w) { return v - 2 * rt::dot(v, w) * w; }},
    {"{0}, turned to the side of {1}", 1.7, [](vec3 v, vec3 w) { return rt::dot(v, w) < 0 ? -v : v; }},
    {"{0}, turned away from {1}", 1.8, [](vec3 v, vec3 w) { return rt::dot(v, w) > 0 ? -v : v; }},
};

constexpr TwoVectors of_two_colors[] = {
    {"{1}", 1.3, [](vec3, vec3 w) { return w; }},
    {"{0} * {1}", 1.6, [](vec3 v, vec3 w) { return v * w; }},
    {"{0} / {1}", 1.8, [](vec3 v, vec3 w) { return v / w; }},
    {"{0} + {1}", 1.7, [](vec3 v, vec3 w) { return v + w; }},
};

template <class... Names>
std::string filled(const char* words, const Names&... names) {
    return fmt::format(fmt::runtime(words), names...);
}

/// "`2 * x` in place of `x`"
std::string in_place(const std::string& expression, const std::string& name) {
    return fmt::format("`{}` in place of `{}`", expression, name);
}

/// A whole number that a fragment can be given.
bool fits(double& x, double before, bool whole) {
    if (!whole) return true;
    if (!(std::abs(x) < 1e6)) return false;
    x = std::floor(x);
    return before <= 0 || x > 0 || before == 1;
}

class Changes {
public:
    Changes(const Layout& layout, const std::vector<bool>& told) : layout_(layout), scalars_(scalars_of(layout, told)) {
        for (std::size_t i = 0; i < layout.parts.size(); ++i) {
            if (i < told.size() && !told[i]) continue;
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

    std::vector<Change> take() { return std::move(all_); }

private:
    void add(std::string words, double cost, std::function<bool(Row&, const Layout&)> make) {
        all_.push_back({std::move(words), cost, std::move(make)});
    }

    const std::string& name(std::size_t part) const { return layout_.parts[part].name; }

    void add_flag(std::size_t i) {
        add(in_place("!" + name(i), name(i)), 1, [i](Row& row, const Layout& l) {
            row[l.parts[i].at] = 1 - row[l.parts[i].at];
            return true;
        });
        for (const double value : {0.0, 1.0})
            add(in_place(value != 0 ? "true" : "false", name(i)), 1.1, [i, value](Row& row, const Layout& l) {
                row[l.parts[i].at] = value;
                return true;
            });
    }

    void add_scalar(const Scalar& s) {
        for (const Function& f : scalar_functions) {
            const bool of_index = s.whole && s.name == "i";
            add(in_place(s.whole && std::string(f.words) == "{} / 2" ? s.name + " / 2 (of whole numbers)"
                                                                     : filled(f.words, s.name),
                         s.name) +
                    f.usually,
                f.cost, [s, f, of_index](Row& row, const Layout& l) {
                    double& x = row[s.at(l)];
                    const double before = x;
                    x = f.value(x);
                    if (of_index && !(x >= 0)) return false;
                    return fits(x, of_index ? 0 : before, s.whole);
                });
        }
        for (const Scalar& other : scalars_) {
            if (other.name == s.name || s.whole != other.whole) continue;
            const double near = s.owner() == other.owner() ? -0.3 : 0;
            for (const TwoScalars& f : of_two_scalars)
                add(in_place(filled(f.words, s.name, other.name), s.name), f.cost + near,
                    [s, other, f](Row& row, const Layout& l) {
                        double& x = row[s.at(l)];
                        const double before = x;
                        x = f.value(x, row[other.at(l)]);
                        return fits(x, before, s.whole);
                    });
            if (s.name < other.name)
                add(fmt::format("`{}` and `{}` exchanged", s.name, other.name), 1.1,
                    [s, other](Row& row, const Layout& l) {
                        std::swap(row[s.at(l)], row[other.at(l)]);
                        return true;
                    });
        }
    }

    template <class Functions, class TwoFunctions>
    void add_vector(std::size_t i, const std::vector<std::size_t>& others, const Functions& functions,
                    const TwoFunctions& of_two) {
        for (const VectorFunction& f : functions)
            add(in_place(filled(f.words, name(i)), name(i)), f.cost, [i, f](Row& row, const Layout& l) {
                put(row, l.parts[i].at, f.value(vector_at(row, l.parts[i].at)));
                return true;
            });
        for (const std::size_t j : others) {
            if (j == i) continue;
            for (const TwoVectors& f : of_two)
                add(in_place(filled(f.words, name(i), name(j)), name(i)), f.cost, [i, j, f](Row& row, const Layout& l) {
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

    /// A vector or colour times a power of a quantity, or of the ratio of two.
    void add_scaled(std::size_t i, double cost) {
        const auto factor = [&](const std::string& words, double more,
                                std::function<double(const Row&, const Layout&)> value) {
            add(in_place(fmt::format("{} * {}", name(i), words), name(i)), cost + more,
                [i, value](Row& row, const Layout& l) {
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

    /// The same to each vector of one struct; to each of a camera's axes.
    void add_joint() {
        std::vector<std::vector<std::size_t>> groups;
        for (const std::size_t i : vectors_) {
            const std::string owner = name(i).substr(0, name(i).rfind('.'));
            if (owner == name(i)) continue;
            if (groups.empty() ||
                name(groups.back().front()).substr(0, name(groups.back().front()).rfind('.')) != owner)
                groups.emplace_back();
            groups.back().push_back(i);
        }
        for (auto group : groups) {
            // a place is no direction
            std::erase_if(group,
                          [&](std::size_t i) { return name(i).ends_with("center") || name(i).ends_with("eye"); });
            if (group.size() < 2) continue;
            std::string names;
            for (const std::size_t i : group) names += (names.empty() ? "`" : ", `") + name(i) + "`";
            for (const VectorFunction& f : vector_functions) {
                if (f.cost > 1.3) continue;
                add(fmt::format("{} in place of each of {}", filled(f.words, "v"), names), f.cost + 0.3,
                    [group, f](Row& row, const Layout& l) {
                        for (const std::size_t i : group)
                            put(row, l.parts[i].at, f.value(vector_at(row, l.parts[i].at)));
                        return true;
                    });
            }
            if (group.size() == 3)
                add(fmt::format("the axes of the world in place of {}", names), 1.2,
                    [group](Row& row, const Layout& l) {
                        for (std::size_t k = 0; k < 3; ++k)
                            put(row, l.parts[group[k]].at, vec3(k == 0, k == 1, k == 2));
                        return true;
                    });
        }
    }

    /// A pair in place of another, as of an extent's corners.
    void add_pairs() {
        for (std::size_t i = 0; i < layout_.parts.size(); ++i)
            for (std::size_t j = 0; j < layout_.parts.size(); ++j) {
                if (i == j || layout_.parts[i].kind != Kind::pair || layout_.parts[j].kind != Kind::pair) continue;
                for (const double more : {0.0, 1.0})
                    add(in_place(more != 0 ? name(j) + " + 1" : name(j), name(i)), 1.6,
                        [i, j, more](Row& row, const Layout& l) {
                            for (std::size_t c = 0; c < 2; ++c) row[l.parts[i].at + c] = row[l.parts[j].at + c] + more;
                            return true;
                        });
            }
    }

    void add_lists() {
        if (layout_.lists.empty() || layout_.lists.front().stride == 0) return;
        for (const bool first : {true, false})
            add(first ? "the first element left out" : "the last element left out", 1.2,
                [first](Row& row, const Layout& l) {
                    for (auto list = l.lists.rbegin(); list != l.lists.rend(); ++list) {
                        if (list->count < 1 || list->stride == 0) return false;
                        const auto start =
                            row.begin() + std::ptrdiff_t(list->at + 1 + (first ? 0 : (list->count - 1) * list->stride));
                        row.erase(start, start + std::ptrdiff_t(list->stride));
                        row[list->at] -= 1;
                    }
                    return true;
                });
        for (std::size_t which = 0; which < layout_.lists.size(); ++which)
            for (const Function& f : scalar_functions) {
                if (f.cost > 1.3) continue;
                const std::string each = layout_.lists[which].name + "[k]";
                add(in_place(filled(f.words, each), each), f.cost + 0.2, [which, f](Row& row, const Layout& l) {
                    const List& list = l.lists[which];
                    for (std::size_t k = 0; k < list.count * list.stride; ++k)
                        row[list.at + 1 + k] = f.value(row[list.at + 1 + k]);
                    return true;
                });
            }
    }

    const Layout& layout_;
    std::vector<Scalar> scalars_;
    std::vector<std::size_t> vectors_, colors_;
    std::vector<Change> all_;
};

}  // namespace

std::vector<Change> changes_of(const Signature&, const Layout& layout, const std::vector<bool>& told) {
    return Changes(layout, told).take();
}

std::vector<Change> same_sampling(const Signature& signature, const Layout& layout) {
    std::vector<Change> all{{"", 0, [](Row&, const Layout&) { return true; }}};
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
    (void)signature;
    return all;
}

std::vector<Quantity> quantities_of(const Layout& layout, const std::vector<bool>& told, const Layout* result) {
    std::vector<Quantity> all;
    for (const Scalar& s : scalars_of(layout, told))
        all.push_back({s.name, [s](const Row& row, const Layout& l, const Row&) { return row[s.at(l)]; }});
    struct Vector {
        std::string name;
        std::size_t part;
        bool own;  // of the answer
        int mirror = -1;
    };
    std::vector<Vector> vectors;
    for (std::size_t i = 0; i < layout.parts.size(); ++i)
        if (layout.parts[i].kind == Kind::vector && (i >= told.size() || told[i]))
            vectors.push_back({layout.parts[i].name, i, false});
    if (result)
        for (const Field& part : result->parts)
            if (part.kind == Kind::vector && !part.name.empty())
                vectors.push_back({"the answer's " + part.name, part.at, true});
    // where the answer is a direction: mirrored ones, which it may be measured from
    const std::size_t given = vectors.size() - std::size_t(std::ranges::count(vectors, true, &Vector::own));
    const bool has_own = given < vectors.size();
    for (std::size_t a = 0; has_own && a < given; ++a)
        for (std::size_t b = 0; b < given; ++b)
            if (a != b)
                vectors.push_back({fmt::format("{} mirrored at {}", vectors[a].name, vectors[b].name), vectors[a].part,
                                   false, int(vectors[b].part)});
    const auto at = [](const Vector& v, const Row& row, const Layout& l, const Row& output) {
        if (v.mirror >= 0) {
            const vec3 d = vector_at(row, l.parts[v.part].at), n = vector_at(row, l.parts[std::size_t(v.mirror)].at);
            return d - 2 * rt::dot(d, n) * n;
        }
        return v.own ? vector_at(output, v.part) : vector_at(row, l.parts[v.part].at);
    };
    for (std::size_t a = 0; a < vectors.size(); ++a) {
        const Vector v = vectors[a];
        if (v.mirror >= 0) continue;
        all.push_back({fmt::format("|{}|", v.name),
                       [=](const Row& row, const Layout& l, const Row& out) { return length(at(v, row, l, out)); }});
        for (std::size_t b = a + 1; b < vectors.size(); ++b) {
            const Vector w = vectors[b];
            if (w.mirror >= 0 && !v.own) continue;
            all.push_back(
                {fmt::format("dot({}, {})", v.name, w.name), [=](const Row& row, const Layout& l, const Row& out) {
                     return rt::dot(at(v, row, l, out), at(w, row, l, out));
                 }});
            all.push_back(
                {fmt::format("|{} - {}|", v.name, w.name), [=](const Row& row, const Layout& l, const Row& out) {
                     return length(at(v, row, l, out) - at(w, row, l, out));
                 }});
        }
    }
    for (std::size_t i = 0; result && i < result->parts.size(); ++i) {
        const Field part = result->parts[i];
        if (part.kind == Kind::pair && !part.name.empty())
            all.push_back(
                {fmt::format("|the answer's {}|", part.name), [part](const Row&, const Layout&, const Row& out) {
                     return std::hypot(out[part.at], out[part.at + 1]);
                 }});
        if (part.kind == Kind::number && part.name == "distance")
            all.push_back({fmt::format("the answer's {}", part.name),
                           [part](const Row&, const Layout&, const Row& out) { return out[part.at]; }});
        if (part.kind == Kind::vector && !part.name.empty())
            all.push_back({fmt::format("the answer's {}.z", part.name),
                           [part](const Row&, const Layout&, const Row& out) { return out[part.at + 2]; }});
    }
    for (std::size_t i = 0; i < layout.lists.size(); ++i) {
        all.push_back({fmt::format("the number of {}", layout.lists[i].name),
                       [i](const Row&, const Layout& l, const Row&) { return double(l.lists[i].count); }});
    }
    return all;
}

}  // namespace grade
