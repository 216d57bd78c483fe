#include "child/probes.h"

#include <array>
#include <functional>
#include <map>
#include <string>
#include <tuple>

namespace grade {

namespace {

/// An argument read from a row, kept alive while the fragment runs on it.
template <class Argument>
struct Held {
    Argument value;

    explicit Held(RowReader& in) : value(read(in, Tag<Argument>{})) {}
    const Argument& get() { return value; }
    void use(Numbers&) const {}
};

/// A function that notes where it was asked.
template <>
struct Held<rt::Function> {
    Integrand f;
    double calls = 0, least = rt::inf, greatest = -rt::inf;

    explicit Held(RowReader& in) : f(read(in, Tag<Integrand>{})) {}
    rt::Function get() {
        return [this](double x) {
            ++calls;
            least = std::min(least, x);
            greatest = std::max(greatest, x);
            return f(x);
        };
    }
    void use(Numbers& out) const { out.insert(out.end(), {calls, least, greatest}); }
};

template <class Value>
struct Held<std::span<const Value>> {
    std::vector<Value> values;

    explicit Held(RowReader& in) : values(read(in, Tag<std::vector<Value>>{})) {}
    std::span<const Value> get() { return values; }
    void use(Numbers&) const {}
};

template <>
struct Held<std::span<const rt::Stratum>> {
    std::vector<StratumOf> owners;
    std::vector<rt::Stratum> strata;

    explicit Held(RowReader& in) : owners(read(in, Tag<std::vector<StratumOf>>{})) {
        for (const StratumOf& owner : owners) strata.push_back({owner.low, owner.high, owner.u});
    }
    std::span<const rt::Stratum> get() { return strata; }
    void use(Numbers&) const {}
};

template <class Result, class... Arguments>
Numbers call(Result (*fragment)(Arguments...), std::span<const double> row) {
    RowReader in(row);
    std::tuple<Held<std::decay_t<Arguments>>...> held{Held<std::decay_t<Arguments>>(in)...};
    if (!in.at_end()) throw std::domain_error("the row is too long");
    Numbers out;
    std::apply([&](auto&... argument) { append(out, fragment(argument.get()...)); }, held);
    std::apply([&](auto&... argument) { (argument.use(out), ...); }, held);
    return out;
}

using Caller = std::function<Numbers(std::span<const double>)>;

template <class Fragment>
Caller caller(Fragment* fragment) {
    return [fragment](std::span<const double> row) { return call(fragment, row); };
}

const std::map<std::string, Caller, std::less<>>& callers() {
    static const std::map<std::string, Caller, std::less<>> all = {
        {"integrate_uniform", caller(rt::integrate_uniform)},
        {"integrate_monte_carlo", caller(rt::integrate_monte_carlo)},
        {"integrate_stratified", caller(rt::integrate_stratified)},
        {"camera_ray", caller(rt::camera_ray)},
        {"hit_sphere", caller(rt::hit_sphere)},
        {"hit_triangle", caller(rt::hit_triangle)},
        {"hit_quad", caller(rt::hit_quad)},
        {"point_irradiance", caller(rt::point_irradiance)},
        {"phong", caller(rt::phong)},
        {"shadow_ray", caller(rt::shadow_ray)},
        {"mirror_direction", caller(rt::mirror_direction)},
        {"refracted_direction", caller(rt::refracted_direction)},
        {"fresnel_dielectric", caller(rt::fresnel_dielectric)},
        {"whitted", caller(rt::whitted)},
        {"stratified_2d", caller(rt::stratified_2d)},
        {"uniform_disk", caller(rt::uniform_disk)},
        {"cosine_hemisphere", caller(rt::cosine_hemisphere)},
        {"phong_lobe", caller(rt::phong_lobe)},
        {"sphere_cone", caller(rt::sphere_cone)},
        {"film_sample", caller(rt::film_sample)},
        {"pixel_mean", caller(rt::pixel_mean)},
        {"light_sample", caller(rt::light_sample)},
        {"direct_light", caller(rt::direct_light)},
        {"glossy_reflection", caller(rt::glossy_reflection)},
        {"translucency", caller(rt::translucency)},
        {"lens_ray", caller(rt::lens_ray)},
        {"shutter_time", caller(rt::shutter_time)},
        {"moved", caller(rt::moved)},
        {"color_bleeding", caller(rt::color_bleeding)},
        {"emission_counts", caller(rt::emission_counts)},
        {"free_flight", caller(rt::free_flight)},
        {"scatter_direction", caller(rt::scatter_direction)},
    };
    return all;
}

}  // namespace

std::vector<double> probe(std::string_view fragment, std::span<const double> row) {
    const auto found = callers().find(fragment);
    if (found == callers().end()) throw std::invalid_argument("no fragment is named " + std::string(fragment));
    return found->second(row);
}

}  // namespace grade
