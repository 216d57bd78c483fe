#pragma once

#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

#include "rt/answers.h"

/// Arguments and results of fragments as rows of numbers: what a probe sends to a fragment and gets back.
///
/// A row is the arguments in the order of the declaration, each as its numbers one after the other:
///
///     Real, int, bool, enum      1   bool as 0 or 1, an enum as its position in the declaration
///     vec2, ivec2                2   x y
///     vec3, Color                3   x y z
///     a struct                       its members, in the order of `members` below
///     Integrand              2 + n   kind, n, n parameters
///     list                   1 + …   count, elements
///     Stratum                3 + n   low, high, n, n random numbers
namespace grade {

/// A function of one variable that can be written down as numbers: the f and the density of part 1's integrals.
struct Integrand {
    enum class Kind {
        polynomial,   // c0, c1, ...                       c0 + c1 x + c2 x^2 + ...
        gaussian,     // height, center, width             height exp(-((x - center) / width)^2 / 2)
        lorentzian,   // height, center, width             height / (1 + ((x - center) / width)^2)
        cosine,       // offset, height, frequency, phase  offset + height cos(2 pi frequency x + phase)
        exponential,  // height, rate                      height exp(-rate x)
        power,        // height, exponent                  height x^exponent
        step,         // edge, below, above                below where x < edge, else above
    };
    Kind kind = Kind::polynomial;
    std::vector<double> parameters;

    double operator()(double x) const;
};

/// A stratum that owns its random numbers.
struct StratumOf {
    double low = 0, high = 1;
    std::vector<double> u;
};

// ---- the types of several numbers: a line each, with the members in the order of a row ----

inline auto members(rt::vec2& v) { return std::tie(v.x, v.y); }
inline auto members(rt::ivec2& v) { return std::tie(v.x, v.y); }
inline auto members(rt::vec3& v) { return std::tie(v.x, v.y, v.z); }
inline auto members(rt::Ray& x) { return std::tie(x.origin, x.direction, x.near, x.far); }
inline auto members(rt::Hit& x) { return std::tie(x.point, x.normal, x.error); }
inline auto members(rt::Sphere& x) { return std::tie(x.center, x.radius); }
inline auto members(rt::Triangle& x) { return std::tie(x.a, x.b, x.c); }
inline auto members(rt::Quad& x) { return std::tie(x.center, x.u, x.v); }
inline auto members(rt::Disc& x) { return std::tie(x.center, x.normal, x.radius); }
inline auto members(rt::Camera& x) {
    return std::tie(x.eye, x.right, x.up, x.back, x.tan_half_fov, x.size, x.lens_radius, x.focus);
}
inline auto members(rt::Shutter& x) { return std::tie(x.open, x.close); }
inline auto members(rt::Extent& x) { return std::tie(x.low, x.high); }
inline auto members(rt::PointLight& x) { return std::tie(x.position, x.intensity, x.directional); }
inline auto members(rt::Emitter& x) { return std::tie(x.kind, x.quad, x.disc, x.sphere, x.radiance); }
inline auto members(rt::Material& x) {
    return std::tie(x.ambient, x.albedo, x.specular, x.shininess, x.reflectance, x.transmittance, x.exponent, x.ior,
                    x.emission, x.sampled, x.medium.extinction, x.medium.albedo, x.medium.g);
}
inline auto members(rt::LightSample& x) { return std::tie(x.direction, x.distance, x.density); }
inline auto members(rt::DiskSample& x) { return std::tie(x.point, x.density); }
inline auto members(rt::DirectionSample& x) { return std::tie(x.direction, x.density); }
inline auto members(rt::FilmSample& x) { return std::tie(x.position, x.weight); }
inline auto members(rt::Scattered& x) { return std::tie(x.direction, x.weight); }
inline auto members(rt::Outgoing& x) { return std::tie(x.local, x.mirror, x.glass); }
inline auto members(Integrand& x) { return std::tie(x.kind, x.parameters); }
inline auto members(StratumOf& x) { return std::tie(x.low, x.high, x.u); }

template <class Value>
concept HasMembers = requires(Value x) {
    members(x);
};

template <class Value>
concept Enum = std::is_enum_v<Value>;

// ---- writing ----

using Numbers = std::vector<double>;

inline void append(Numbers& row, double x) { row.push_back(x); }
inline void append(Numbers& row, int x) { row.push_back(x); }
inline void append(Numbers& row, bool x) { row.push_back(x ? 1 : 0); }
inline void append(Numbers& row, Enum auto x) { row.push_back(double(int(x))); }

// Declared before what writes members: argument-dependent lookup does not find it for a list of numbers or of rt's.
template <class Value>
void append(Numbers& row, const std::vector<Value>& list);

template <HasMembers Value>
void append(Numbers& row, Value x) {
    std::apply([&](const auto&... member) { (append(row, member), ...); }, members(x));
}

/// A list: how many, then each.
template <class Value>
void append(Numbers& row, const std::vector<Value>& list) {
    row.push_back(double(list.size()));
    for (const Value& value : list) append(row, value);
}

/// The row of a call: row(d, n, 1.0, 1.5) for refracted_direction(d, n, 1.0, 1.5).
template <class... Arguments>
Numbers row(const Arguments&... arguments) {
    Numbers numbers;
    (append(numbers, arguments), ...);
    return numbers;
}

// ---- reading ----

/// Takes numbers from the front of a row. Throws std::out_of_range where the row is too short, std::domain_error where
/// a count is no count, or a whole number none.
class RowReader {
public:
    explicit RowReader(std::span<const double> row) : rest(row) {}

    double number();
    /// That an int can hold: a position in an enum, a count of pixels.
    int whole();
    std::size_t count();
    bool at_end() const { return rest.empty(); }

private:
    std::span<const double> rest;
};

template <class Value>
struct Tag {};

inline double read(RowReader& in, Tag<double>) { return in.number(); }
inline int read(RowReader& in, Tag<int>) { return in.whole(); }
inline bool read(RowReader& in, Tag<bool>) { return in.number() != 0; }

template <Enum Value>
Value read(RowReader& in, Tag<Value>) {
    return Value(in.whole());
}

template <HasMembers Value>
Value read(RowReader& in, Tag<Value>) {
    Value x;
    std::apply([&](auto&... member) { ((member = read(in, Tag<std::decay_t<decltype(member)>>{})), ...); }, members(x));
    return x;
}

template <class Value>
std::vector<Value> read(RowReader& in, Tag<std::vector<Value>>) {
    std::vector<Value> list(in.count());
    for (Value& value : list) value = read(in, Tag<Value>{});
    return list;
}

/// A value at the front of a row of results: auto [direction, density] = from_row<rt::DirectionSample>(output).
template <class Value>
Value from_row(std::span<const double> row) {
    RowReader in(row);
    return read(in, Tag<Value>{});
}

}  // namespace grade
