#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "rt/math.h"

/// Arithmetic with 80 decimal digits, in which the textbook's formulas are right as they stand: for the truths of
/// families.
namespace grade::stress {

using Exact = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<80>, boost::multiprecision::et_off>;

struct Exact3 {
    Exact x, y, z;

    Exact3(Exact a, Exact b, Exact c) : x(std::move(a)), y(std::move(b)), z(std::move(c)) {}
    explicit Exact3(rt::vec3 v) : x(v.x), y(v.y), z(v.z) {}
};

inline Exact3 operator+(const Exact3& a, const Exact3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Exact3 operator-(const Exact3& a, const Exact3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Exact3 operator*(const Exact& s, const Exact3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Exact dot(const Exact3& a, const Exact3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Exact3 cross(const Exact3& a, const Exact3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Exact length(const Exact3& a) { return sqrt(dot(a, a)); }
inline Exact3 unit(const Exact3& a) { return (1 / length(a)) * a; }

/// |a - b| as a number of the machine.
inline double apart(const Exact3& a, rt::vec3 b) { return double(length(a - Exact3(b))); }
inline double apart(const Exact& a, double b) { return std::isfinite(b) ? double(abs(a - b)) : rt::inf; }

}  // namespace grade::stress
