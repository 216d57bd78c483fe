#include <fmt/format.h>

#include "rt/files/mitsuba_parts.h"

namespace rt {
namespace {

/// The squares of a checker on a quad, in its texture coordinates from 0 to 1; two squares each way are a period.
std::string squares(const Quad& quad, Real size) {
    const vec2 half = vec2(length(quad.u), length(quad.v)) / size;
    return fmt::format(
        "<transform name=\"to_uv\"><scale x=\"{:.10g}\" y=\"{:.10g}\"/>"
        "<translate x=\"{:.10g}\" y=\"{:.10g}\"/></transform>",
        half.x, half.y, -half.x / 2, -half.y / 2);
}

/// The diffuse part, divided by `share`.
std::string diffuse(const Material& m, const Quad* quad, Real share) {
    const std::string reflectance =
        m.checker && quad
            ? "<texture type=\"checkerboard\" name=\"reflectance\">" + xml_color("color0", m.albedo / share) +
                  xml_color("color1", m.checker->albedo / share) + squares(*quad, m.checker->size) + "</texture>"
            : xml_color("reflectance", m.albedo / share);
    return "<bsdf type=\"diffuse\">" + reflectance + "</bsdf>";
}

std::string two_sided(const std::string& bsdf) { return "<bsdf type=\"twosided\">" + bsdf + "</bsdf>"; }

/// Mirror, glass or lobe, their colours divided by `share`.
std::string specular(const Material& m, Real share) {
    const Color mirror = m.reflectance / share, glass = m.transmittance / share;
    if (m.exponent < inf)
        return "<bsdf type=\"penumbra_lobe\">" + xml_number("exponent", m.exponent) + xml_number("ior", m.ior) +
               xml_color("reflectance", mirror) + xml_color("transmittance", glass) + "</bsdf>";
    if (m.transmittance != Color(0))
        return "<bsdf type=\"dielectric\">" + xml_number("int_ior", m.ior) + xml_number("ext_ior", 1) +
               xml_color("specular_reflectance", mirror) + xml_color("specular_transmittance", glass) + "</bsdf>";
    return two_sided("<bsdf type=\"conductor\"><string name=\"material\" value=\"none\"/>" +
                     xml_color("specular_reflectance", mirror) + "</bsdf>");
}

std::string with_id(std::string bsdf, const std::string& id) {
    if (id.empty()) return bsdf;
    return bsdf.insert(std::string("<bsdf").size(), fmt::format(" id=\"{}\"", id));
}

}  // namespace

std::string coordinates(vec3 v) { return fmt::format("{:.10g}, {:.10g}, {:.10g}", v.x, v.y, v.z); }

std::string xml_number(const char* name, Real x) {
    return fmt::format("<float name=\"{}\" value=\"{:.10g}\"/>", name, x);
}

std::string xml_color(const char* name, Color c) {
    return fmt::format("<rgb name=\"{}\" value=\"{}\"/>", name, coordinates(c));
}

std::string xml_point(const char* name, vec3 p) {
    return fmt::format("<point name=\"{}\" value=\"{}\"/>", name, coordinates(p));
}

bool has_medium(const Material& m) { return m.transmittance != Color(0) && m.medium.extinction > 0; }

bool is_null_boundary(const Material& m) {
    return m.transmittance == Color(1) && m.ior == 1 && m.exponent == inf && largest_albedo(m) == Color(0);
}

std::string mitsuba_surface(const Material& m, const std::string& id, const Quad* quad) {
    if (is_null_boundary(m)) return with_id("<bsdf type=\"null\"/>", id);
    const Real share = std::max(largest(m.reflectance), largest(m.transmittance));
    if (share == 0) return with_id(two_sided(diffuse(m, quad, 1)), id);
    if (largest_albedo(m) == Color(0)) return with_id(specular(m, 1), id);
    // Both: a mixture, whose parts are brighter by as much as they are rarer.
    return with_id("<bsdf type=\"blendbsdf\">" + xml_number("weight", share) + two_sided(diffuse(m, quad, 1 - share)) +
                       specular(m, share) + "</bsdf>",
                   id);
}

std::string mitsuba_medium_at(const World& world, Bits inside, const char* name) {
    const Index material = world.regions.medium(inside);
    return material == nothing ? "" : fmt::format("<ref name=\"{}\" id=\"medium{}\"/>", name, material);
}

std::string mitsuba_medium(const Medium& medium, const std::string& id) {
    return fmt::format("<medium type=\"homogeneous\" id=\"{}\">", id) + xml_number("sigma_t", medium.extinction) +
           xml_color("albedo", medium.albedo) +
           (medium.g == 0 ? "<phase type=\"isotropic\"/>"
                          : "<phase type=\"hg\">" + xml_number("g", medium.g) + "</phase>") +
           "</medium>";
}

}  // namespace rt
