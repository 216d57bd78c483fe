#include "protocol/rows.h"

#include <cmath>
#include <stdexcept>

namespace grade {

double Integrand::operator()(double x) const {
    const auto at = [&](std::size_t i) { return parameters.at(i); };
    switch (kind) {
        case Kind::polynomial: {
            double sum = 0;
            for (std::size_t i = parameters.size(); i-- > 0;) sum = sum * x + parameters[i];
            return sum;
        }
        case Kind::gaussian:
            return at(0) * std::exp(-rt::sqr((x - at(1)) / at(2)) / 2);
        case Kind::lorentzian:
            return at(0) / (1 + rt::sqr((x - at(1)) / at(2)));
        case Kind::cosine:
            return at(0) + at(1) * std::cos(2 * rt::pi * at(2) * x + at(3));
        case Kind::exponential:
            return at(0) * std::exp(-at(1) * x);
        case Kind::power:
            return at(0) * std::pow(x, at(1));
        case Kind::step:
            return x < at(0) ? at(1) : at(2);
    }
    throw std::domain_error("an integrand of an unknown kind");
}

double RowReader::number() {
    if (rest.empty()) throw std::out_of_range("the row is too short");
    const double x = rest.front();
    rest = rest.subspan(1);
    return x;
}

std::size_t RowReader::count() {
    const double n = number();
    if (!(n >= 0 && n <= double(rest.size()) && n == std::floor(n))) throw std::domain_error("a count is no count");
    return std::size_t(n);
}

namespace {

/// A number that an int can hold: a position in an enum, a count of pixels.
int whole(RowReader& in) {
    const double x = in.number();
    if (!(x >= -2147483648.0 && x <= 2147483647.0)) throw std::domain_error("a whole number is none");
    return int(x);
}

}  // namespace

// The members of each type, in the order of rows.h: once, for writing and for reading.
namespace {

template <class Each>
void members(rt::Ray& x, Each each) {
    each(x.origin, x.direction, x.near, x.far);
}
template <class Each>
void members(rt::Hit& x, Each each) {
    each(x.point, x.normal, x.error);
}
template <class Each>
void members(rt::Sphere& x, Each each) {
    each(x.center, x.radius);
}
template <class Each>
void members(rt::Triangle& x, Each each) {
    each(x.a, x.b, x.c);
}
template <class Each>
void members(rt::Quad& x, Each each) {
    each(x.center, x.u, x.v);
}
template <class Each>
void members(rt::Disc& x, Each each) {
    each(x.center, x.normal, x.radius);
}
template <class Each>
void members(rt::Camera& x, Each each) {
    each(x.eye, x.right, x.up, x.back, x.tan_half_fov, x.size, x.lens_radius, x.focus);
}
template <class Each>
void members(rt::Shutter& x, Each each) {
    each(x.open, x.close);
}
template <class Each>
void members(rt::Extent& x, Each each) {
    each(x.low, x.high);
}
template <class Each>
void members(rt::PointLight& x, Each each) {
    each(x.position, x.intensity, x.directional);
}
template <class Each>
void members(rt::Material& x, Each each) {
    each(x.ambient, x.albedo, x.specular, x.shininess, x.reflectance, x.transmittance, x.exponent, x.ior, x.emission,
         x.sampled, x.medium.extinction, x.medium.albedo, x.medium.g);
}
template <class Each>
void members(rt::LightSample& x, Each each) {
    each(x.direction, x.distance, x.density);
}
template <class Each>
void members(rt::DiskSample& x, Each each) {
    each(x.point, x.density);
}
template <class Each>
void members(rt::DirectionSample& x, Each each) {
    each(x.direction, x.density);
}
template <class Each>
void members(rt::FilmSample& x, Each each) {
    each(x.position, x.weight);
}
template <class Each>
void members(rt::Scattered& x, Each each) {
    each(x.direction, x.weight);
}
template <class Each>
void members(rt::Outgoing& x, Each each) {
    each(x.local, x.mirror, x.glass);
}
template <class Each>
void members(StratumOf& x, Each each) {
    each(x.low, x.high, x.u);
}

template <class Value>
void append_members(Numbers& row, Value value) {
    members(value, [&](auto&... member) { (append(row, member), ...); });
}

template <class Value>
Value read_members(RowReader& in) {
    Value value;
    members(value, [&](auto&... member) { ((member = read(in, Tag<std::decay_t<decltype(member)>>{})), ...); });
    return value;
}

}  // namespace

void append(Numbers& row, const rt::Ray& ray) { append_members(row, ray); }
void append(Numbers& row, const rt::Hit& hit) { append_members(row, hit); }
void append(Numbers& row, const rt::Sphere& sphere) { append_members(row, sphere); }
void append(Numbers& row, const rt::Triangle& triangle) { append_members(row, triangle); }
void append(Numbers& row, const rt::Quad& quad) { append_members(row, quad); }
void append(Numbers& row, const rt::Disc& disc) { append_members(row, disc); }
void append(Numbers& row, const rt::Camera& camera) { append_members(row, camera); }
void append(Numbers& row, const rt::Shutter& shutter) { append_members(row, shutter); }
void append(Numbers& row, const rt::Extent& extent) { append_members(row, extent); }
void append(Numbers& row, const rt::PointLight& light) { append_members(row, light); }
void append(Numbers& row, const rt::Material& material) { append_members(row, material); }
void append(Numbers& row, const rt::LightSample& sample) { append_members(row, sample); }
void append(Numbers& row, const rt::DiskSample& sample) { append_members(row, sample); }
void append(Numbers& row, const rt::DirectionSample& sample) { append_members(row, sample); }
void append(Numbers& row, const rt::FilmSample& sample) { append_members(row, sample); }
void append(Numbers& row, const rt::Scattered& scattered) { append_members(row, scattered); }
void append(Numbers& row, const rt::Outgoing& outgoing) { append_members(row, outgoing); }
void append(Numbers& row, const StratumOf& stratum) { append_members(row, stratum); }

void append(Numbers& row, const rt::Emitter& light) {
    append(row, int(light.kind));
    append(row, light.quad);
    append(row, light.disc);
    append(row, light.sphere);
    append(row, light.radiance);
}

void append(Numbers& row, const Integrand& f) {
    append(row, int(f.kind));
    append(row, f.parameters);
}

double read(RowReader& in, Tag<double>) { return in.number(); }
int read(RowReader& in, Tag<int>) { return whole(in); }
bool read(RowReader& in, Tag<bool>) { return in.number() != 0; }
rt::Event read(RowReader& in, Tag<rt::Event>) { return rt::Event(whole(in)); }

// A braced list is read from left to right.
rt::vec2 read(RowReader& in, Tag<rt::vec2>) { return rt::vec2{in.number(), in.number()}; }
rt::ivec2 read(RowReader& in, Tag<rt::ivec2>) { return rt::ivec2{whole(in), whole(in)}; }
rt::vec3 read(RowReader& in, Tag<rt::vec3>) { return rt::vec3{in.number(), in.number(), in.number()}; }

rt::Ray read(RowReader& in, Tag<rt::Ray>) { return read_members<rt::Ray>(in); }
rt::Hit read(RowReader& in, Tag<rt::Hit>) { return read_members<rt::Hit>(in); }
rt::Sphere read(RowReader& in, Tag<rt::Sphere>) { return read_members<rt::Sphere>(in); }
rt::Triangle read(RowReader& in, Tag<rt::Triangle>) { return read_members<rt::Triangle>(in); }
rt::Quad read(RowReader& in, Tag<rt::Quad>) { return read_members<rt::Quad>(in); }
rt::Disc read(RowReader& in, Tag<rt::Disc>) { return read_members<rt::Disc>(in); }
rt::Camera read(RowReader& in, Tag<rt::Camera>) { return read_members<rt::Camera>(in); }
rt::Shutter read(RowReader& in, Tag<rt::Shutter>) { return read_members<rt::Shutter>(in); }
rt::Extent read(RowReader& in, Tag<rt::Extent>) { return read_members<rt::Extent>(in); }
rt::PointLight read(RowReader& in, Tag<rt::PointLight>) { return read_members<rt::PointLight>(in); }
rt::Material read(RowReader& in, Tag<rt::Material>) { return read_members<rt::Material>(in); }
rt::LightSample read(RowReader& in, Tag<rt::LightSample>) { return read_members<rt::LightSample>(in); }
rt::DiskSample read(RowReader& in, Tag<rt::DiskSample>) { return read_members<rt::DiskSample>(in); }
rt::DirectionSample read(RowReader& in, Tag<rt::DirectionSample>) { return read_members<rt::DirectionSample>(in); }
rt::FilmSample read(RowReader& in, Tag<rt::FilmSample>) { return read_members<rt::FilmSample>(in); }
rt::Scattered read(RowReader& in, Tag<rt::Scattered>) { return read_members<rt::Scattered>(in); }
rt::Outgoing read(RowReader& in, Tag<rt::Outgoing>) { return read_members<rt::Outgoing>(in); }
StratumOf read(RowReader& in, Tag<StratumOf>) { return read_members<StratumOf>(in); }

rt::Emitter read(RowReader& in, Tag<rt::Emitter>) {
    rt::Emitter light;
    light.kind = rt::Emitter::Kind(whole(in));
    light.quad = read(in, Tag<rt::Quad>{});
    light.disc = read(in, Tag<rt::Disc>{});
    light.sphere = read(in, Tag<rt::Sphere>{});
    light.radiance = read(in, Tag<rt::vec3>{});
    return light;
}

Integrand read(RowReader& in, Tag<Integrand>) {
    Integrand f;
    f.kind = Integrand::Kind(whole(in));
    f.parameters = read(in, Tag<std::vector<double>>{});
    return f;
}

}  // namespace grade
