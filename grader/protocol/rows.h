#pragma once

#include <span>
#include <vector>

#include "rt/answers.h"

/// Arguments and results of fragments as rows of numbers: what a probe sends to a fragment and gets back.
///
/// A row is the arguments in the order of the declaration, each as its numbers one after the other:
///
///     Real, int, bool, enum      1   bool as 0 or 1, an enum as its position in the declaration
///     vec2, ivec2                2   x y
///     vec3, Color                3   x y z
///     Ray                        8   origin, direction, near, far
///     Hit                        7   point, normal, error
///     Sphere                     4   center, radius
///     Triangle                   9   a, b, c
///     Quad                       9   center, u, v
///     Disc                       7   center, normal, radius
///     Camera                    17   eye, right, up, back, tan_half_fov, size (2), lens_radius, focus
///     Shutter                    2   open, close
///     Extent                     4   low (2), high (2)
///     PointLight                 7   position, intensity, directional
///     Emitter                   24   kind, quad, disc, sphere, radiance
///     Material                  27   ambient, albedo, specular, shininess, reflectance, transmittance, exponent, ior,
///                                    emission, sampled, extinction, medium albedo, g
///     LightSample                5   direction, distance, density
///     DiskSample                 3   point (2), density
///     DirectionSample            4   direction, density
///     FilmSample                 3   position (2), weight
///     Scattered                  6   direction, weight
///     Outgoing                   9   local, mirror, glass
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

// ---- writing ----

using Numbers = std::vector<double>;

inline void append(Numbers& row, double x) { row.push_back(x); }
inline void append(Numbers& row, int x) { row.push_back(x); }
inline void append(Numbers& row, bool x) { row.push_back(x ? 1 : 0); }
inline void append(Numbers& row, rt::Event x) { row.push_back(double(int(x))); }
inline void append(Numbers& row, rt::vec2 v) { append(row, v.x), append(row, v.y); }
inline void append(Numbers& row, rt::ivec2 v) { append(row, v.x), append(row, v.y); }
inline void append(Numbers& row, rt::vec3 v) { append(row, v.x), append(row, v.y), append(row, v.z); }

void append(Numbers& row, const rt::Ray& ray);
void append(Numbers& row, const rt::Hit& hit);
void append(Numbers& row, const rt::Sphere& sphere);
void append(Numbers& row, const rt::Triangle& triangle);
void append(Numbers& row, const rt::Quad& quad);
void append(Numbers& row, const rt::Disc& disc);
void append(Numbers& row, const rt::Camera& camera);
void append(Numbers& row, const rt::Shutter& shutter);
void append(Numbers& row, const rt::Extent& extent);
void append(Numbers& row, const rt::PointLight& light);
void append(Numbers& row, const rt::Emitter& light);
void append(Numbers& row, const rt::Material& material);
void append(Numbers& row, const rt::LightSample& sample);
void append(Numbers& row, const rt::DiskSample& sample);
void append(Numbers& row, const rt::DirectionSample& sample);
void append(Numbers& row, const rt::FilmSample& sample);
void append(Numbers& row, const rt::Scattered& scattered);
void append(Numbers& row, const rt::Outgoing& outgoing);
void append(Numbers& row, const Integrand& f);
void append(Numbers& row, const StratumOf& stratum);

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
/// a count is no count.
class RowReader {
public:
    explicit RowReader(std::span<const double> row) : rest(row) {}

    double number();
    std::size_t count();
    bool at_end() const { return rest.empty(); }

private:
    std::span<const double> rest;
};

template <class Value>
struct Tag {};

double read(RowReader& in, Tag<double>);
int read(RowReader& in, Tag<int>);
bool read(RowReader& in, Tag<bool>);
rt::Event read(RowReader& in, Tag<rt::Event>);
rt::vec2 read(RowReader& in, Tag<rt::vec2>);
rt::ivec2 read(RowReader& in, Tag<rt::ivec2>);
rt::vec3 read(RowReader& in, Tag<rt::vec3>);
rt::Ray read(RowReader& in, Tag<rt::Ray>);
rt::Hit read(RowReader& in, Tag<rt::Hit>);
rt::Sphere read(RowReader& in, Tag<rt::Sphere>);
rt::Triangle read(RowReader& in, Tag<rt::Triangle>);
rt::Quad read(RowReader& in, Tag<rt::Quad>);
rt::Disc read(RowReader& in, Tag<rt::Disc>);
rt::Camera read(RowReader& in, Tag<rt::Camera>);
rt::Shutter read(RowReader& in, Tag<rt::Shutter>);
rt::Extent read(RowReader& in, Tag<rt::Extent>);
rt::PointLight read(RowReader& in, Tag<rt::PointLight>);
rt::Emitter read(RowReader& in, Tag<rt::Emitter>);
rt::Material read(RowReader& in, Tag<rt::Material>);
rt::LightSample read(RowReader& in, Tag<rt::LightSample>);
rt::DiskSample read(RowReader& in, Tag<rt::DiskSample>);
rt::DirectionSample read(RowReader& in, Tag<rt::DirectionSample>);
rt::FilmSample read(RowReader& in, Tag<rt::FilmSample>);
rt::Scattered read(RowReader& in, Tag<rt::Scattered>);
rt::Outgoing read(RowReader& in, Tag<rt::Outgoing>);
Integrand read(RowReader& in, Tag<Integrand>);
StratumOf read(RowReader& in, Tag<StratumOf>);

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
