#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "diagnosis/calls/arguments.h"

namespace grade {

/// A fragment's answers to calls; fewer than there are calls where it gave none.
using Ask = std::function<Rows(const Rows& calls)>;

/// Calls of a fragment, with its answers and the right ones.
struct Calls {
    Signature signature;
    Rows rows, mine, right;
    std::vector<Layout> layouts;  // of the rows
    Layout result;
    std::vector<bool> told;  // by argument's part: whether any answer depends on it

    std::size_t size() const { return rows.size(); }
    bool is_wrong(std::size_t k) const;
    std::vector<std::size_t> wrong() const;         // which calls
    std::vector<const Field*> wrong_parts() const;  // of the result, in some call
};

/// Below so many wrong calls, anything may be chance.
constexpr std::size_t enough_wrong = 5;

/// Those calls of which is_kept(k) holds.
template <class Kept>
Calls those_of(const Calls& calls, Kept is_kept) {
    Calls some{calls.signature, {}, {}, {}, {}, calls.result, calls.told};
    for (std::size_t k = 0; k < calls.size(); ++k) {
        if (!is_kept(k)) continue;
        some.rows.push_back(calls.rows[k]), some.layouts.push_back(calls.layouts[k]);
        some.mine.push_back(calls.mine[k]), some.right.push_back(calls.right[k]);
    }
    return some;
}

/// The parts that are told of these calls: of a shape that is one of several kinds, those of the kind that all have.
std::vector<bool> told_of(const Calls& calls, const std::vector<std::size_t>& scope);

/// Whether a part of an answer says where something is; else how much.
inline bool is_place(const Field& part) { return part.kind == Kind::vector || part.kind == Kind::pair; }

/// How far apart two answers may be that count as equal: single precision is.
constexpr double equal_within = 1e-4;

/// The size of a part of an answer.
inline double scale_of(const Field& part, const Row& a, const Row& b) {
    double scale = 1e-9;
    for (std::size_t c = 0; c < size_of(part.kind); ++c)
        for (const double x : {a[part.at + c], b[part.at + c]})
            if (std::isfinite(x)) scale = std::max(scale, std::abs(x));
    return scale;
}

inline bool is_close(double x, double y, double scale, double within = equal_within) {
    return x == y || (std::isnan(x) && std::isnan(y)) || std::abs(x - y) <= within * scale;
}

/// Whether a part of two answers is equal.
inline bool is_equal(const Field& part, const Row& a, const Row& b, double within = equal_within) {
    constexpr double fine = 1e-6;  // short_of_light is 1 - 2^-30
    const double scale = scale_of(part, a, b), share = part.name == "far" && within == equal_within ? fine : 1;
    for (std::size_t c = 0; c < size_of(part.kind); ++c)
        if (!is_close(a[part.at + c], b[part.at + c], scale, within * share)) return false;
    return true;
}

inline bool is_measure(const Field& part) { return part.name == "density" || part.name == "weight"; }

/// Whether an answer counts for nothing, as its density or its weight says: the rest of it may be anything.
inline bool is_void(const Layout& result, const Row& answer) {
    const auto part = std::ranges::find_if(result.parts, is_measure);
    if (result.parts.size() < 2 || part == result.parts.end()) return false;
    for (std::size_t c = 0; c < size_of(part->kind); ++c)
        if (answer[part->at + c] != 0) return false;
    return true;
}

/// Whether a part of two answers is to be compared.
inline bool counts(const Layout& result, const Field& part, const Row& a, const Row& b) {
    return is_measure(part) || (!is_void(result, a) && !is_void(result, b));
}

/// Whether mine is no number where the right one is.
inline bool is_nan(const Row& mine, const Row& right) {
    const auto has_nan = [](const Row& row) {
        return std::ranges::any_of(row, [](double x) { return std::isnan(x); });
    };
    return has_nan(mine) && !has_nan(right);
}

inline bool is_alike(const Layout& result, const Row& a, const Row& b, double within) {
    if (is_void(result, a) && is_void(result, b)) return !is_nan(a, b) && !is_nan(b, a);
    return std::ranges::all_of(result.parts, [&](const Field& part) { return is_equal(part, a, b, within); });
}

inline bool is_equal(const Layout& result, const Row& a, const Row& b) { return is_alike(result, a, b, equal_within); }

/// Whether an answer, which may be too short, is that one.
inline bool is_answer(const Layout& result, const Row& answer, const Row& wanted) {
    return answer.size() == wanted.size() && is_equal(result, answer, wanted);
}

/// Whether there is more in an answer than 0 and inf.
inline bool is_something(const Row& answer) {
    return std::ranges::any_of(answer, [](double x) { return std::isfinite(x) && x != 0; });
}

/// "`density`", "the answer"
inline std::string name_of(const Field& part) { return part.name.empty() ? "the answer" : "`" + part.name + "`"; }

}  // namespace grade
