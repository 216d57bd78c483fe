#include "rt/files/mitsuba.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <system_error>

#include "rt/files/mitsuba_parts.h"
#include "rt/files/scene_reader.h"
#include "rt/plan.h"

namespace rt {
namespace {

/// world  of the scene, where it has media
std::string camera(const Scene& scene, const World* world) {
    const Camera& c = scene.camera;
    const bool lens = c.lens_radius > 0;
    // Mitsuba has no plane in focus at infinity; single precision does not tell this one from it.
    const Real focus = c.focus < inf ? c.focus : 1e6 * c.lens_radius;
    std::string xml = fmt::format("  <sensor type=\"{}\">\n    <string name=\"fov_axis\" value=\"y\"/>\n    ",
                                  lens ? "thinlens" : "perspective");
    xml += xml_number("fov", 2 * std::atan(c.tan_half_fov) * (180 / pi)) + xml_number("near_clip", 1e-4) +
           xml_number("far_clip", 1e6);
    if (lens) xml += xml_number("aperture_radius", c.lens_radius) + xml_number("focus_distance", focus);
    xml +=
        fmt::format("\n    <transform name=\"to_world\"><lookat origin=\"{}\" target=\"{}\" up=\"{}\"/></transform>\n",
                    coordinates(c.eye), coordinates(c.eye - c.back), coordinates(c.up));
    if (const std::string medium = world ? mitsuba_medium_at(*world, world->regions.start, "medium") : "";
        !medium.empty())
        xml += "    " + medium + "\n";
    xml += fmt::format("    <sampler type=\"independent\"><integer name=\"sample_count\" value=\"{}\"/></sampler>\n",
                       scene.samples);
    xml += fmt::format(
        "    <film type=\"hdrfilm\"><integer name=\"width\" value=\"{}\"/><integer name=\"height\" value=\"{}\"/>"
        "<rfilter type=\"box\"/>\n      <string name=\"pixel_format\" value=\"rgb\"/>"
        "<string name=\"component_format\" value=\"float32\"/></film>\n  </sensor>\n",
        c.size.x, c.size.y);
    return xml;
}

std::string lights(const Scene& scene) {
    std::string xml;
    for (const PointLight& light : scene.lights) {
        if (light.directional)
            xml +=
                fmt::format("  <emitter type=\"directional\"><vector name=\"direction\" value=\"{}\"/>{}</emitter>\n",
                            coordinates(-light.position), xml_color("irradiance", light.intensity));
        else
            xml += "  <emitter type=\"point\">" + xml_point("position", light.position) +
                   xml_color("intensity", light.intensity) + "</emitter>\n";
    }
    if (scene.environment != Color(0))
        xml += "  <emitter type=\"constant\">" + xml_color("radiance", scene.environment) + "</emitter>\n";
    return xml;
}

bool is_on_quads_alone(const Scene& scene, int material) {
    return std::all_of(
               scene.shapes.begin(), scene.shapes.end(),
               [&](const Shape& s) { return s.material != material || std::holds_alternative<Quad>(s.geometry); }) &&
           std::all_of(scene.meshes.begin(), scene.meshes.end(),
                       [&](const Mesh& mesh) { return mesh.material != material; });
}

/// What Mitsuba has no words for, other than in the lengths of paths.
std::vector<std::string> find_unsaid(const Scene& scene) {
    std::vector<std::string> unsaid;
    const RenderPlan plan = make_plan(scene);
    if (plan.time)
        unsaid.emplace_back("shapes that move while the shutter is open; expected close = open, or no velocity");
    if (scene.background != Color(0))
        unsaid.emplace_back("'background', which only the camera sees; expected 'environment'");
    for (const int i : materials_in_use(scene)) {
        const Material& m = scene.materials[std::size_t(i)];
        const auto say = [&](const char* what) {
            unsaid.push_back(fmt::format("material \"{}\": {}", name_of_material(scene, i), what));
        };
        if (m.specular != Color(0))
            say("Phong's highlight ('specular'); expected a lobe ('reflectance' and 'exponent')");
        if (m.ambient * scene.ambient != Color(0)) say("ambient light; expected 'environment'");
        if (m.checker && !is_on_quads_alone(scene, i)) say("'checker' on other shapes than quads; expected quads");
        const Real share = std::max(largest(m.reflectance), largest(m.transmittance));
        if (largest_albedo(m) == Color(0) || share == 0) continue;
        // Mitsuba weighs a sample of its mixtures by the density of both parts, which a perfect mirror does not have.
        if (m.exponent == inf)
            say("'albedo' on a perfect mirror or clear glass; expected 'exponent', or two materials");
        else if (!(largest(largest_albedo(m)) + share <= 1 && share < 1))
            say("'albedo' and 'reflectance' or 'transmittance' above 1 together; expected at most 1");
    }
    return unsaid;
}

}  // namespace

MitsubaFiles to_mitsuba(const Scene& scene, const std::string& stem) {
    std::vector<std::string> unsaid = find_unsaid(scene);
    const MitsubaPaths paths = mitsuba_paths(scene, unsaid);
    std::optional<World> in_media;
    if (paths.media) in_media = make_world(scene);
    const World* world = in_media ? &*in_media : nullptr;
    if (world && !world->regions.asked.empty())
        unsaid.emplace_back("a camera on the boundary of a medium; expected one within it or outside");
    if (!unsaid.empty()) {
        std::string message;
        for (const std::string& what : unsaid)
            message += fmt::format("{}{}: Mitsuba cannot express {}", message.empty() ? "" : "\n", scene.path, what);
        throw InputError(message);
    }

    MitsubaFiles out;
    out.xml = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";
    if (!paths.comment.empty()) out.xml += "<!-- " + paths.comment + " -->\n";
    out.xml += fmt::format(
        "<scene version=\"3.0.0\">\n  <integrator type=\"{}\"><integer name=\"max_depth\" "
        "value=\"{}\"/></integrator>\n",
        paths.media ? "volpath" : "path", paths.max_depth);
    out.xml += camera(scene, world) + lights(scene);
    for (const int i : materials_in_use(scene)) {
        const Material& m = scene.materials[std::size_t(i)];
        out.xml += "  " + mitsuba_surface(m, fmt::format("material{}", i)) + "\n";
        if (has_medium(m)) out.xml += "  " + mitsuba_medium(m.medium, fmt::format("medium{}", i)) + "\n";
    }
    add_mitsuba_shapes(scene, world, stem, out);
    out.xml += "</scene>\n";
    return out;
}

void export_mitsuba(const Scene& scene, const std::string& path) {
    const std::filesystem::path xml(path);
    const MitsubaFiles files = to_mitsuba(scene, xml.stem().string() + "-mesh");
    const auto write = [](const std::filesystem::path& to, const std::string& contents) {
        std::ofstream file(to, std::ios::binary);
        if (!(file << contents) || !file.flush())
            throw std::runtime_error(to.string() + ": cannot be written: " + std::generic_category().message(errno));
    };
    for (const auto& mesh : files.meshes) write(xml.parent_path() / mesh.name, mesh.contents);
    write(xml, files.xml);
}

}  // namespace rt
