#include <fmt/format.h>

#include <cmath>

#include "rt/files/mitsuba_parts.h"
#include "rt/plan.h"

namespace rt {

MitsubaPaths mitsuba_paths(const Scene& scene, std::vector<std::string>& unsaid) {
    MitsubaPaths paths;
    bool diffuse = false, specular = false, scatters = false, searched = false, found = false;
    Real brightest = 0;
    for (const int i : materials_in_use(scene)) {
        const Material& m = scene.materials[std::size_t(i)];
        diffuse |= largest_albedo(m) != Color(0);
        specular |= m.reflectance != Color(0) || m.transmittance != Color(0);
        scatters |= has_medium(m) && m.medium.albedo != Color(0);
        paths.media |= has_medium(m);
        (m.sampled ? searched : found) |= m.emission != Color(0);
        brightest = std::max(brightest, largest(largest_albedo(m)));
    }
    searched |= !scene.lights.empty() || scene.environment != Color(0);

    if (scatters && !scene.lights.empty())
        unsaid.emplace_back(
            "a light without extent beside a medium that scatters: Mitsuba's media send shadow rays to it; "
            "expected lamps with extent");
    if (!diffuse) {
        if (!paths.media) paths.max_depth = scene.depth + 1;
    } else if (!specular && searched != found) {
        // Camera, bounces + 1 surfaces, lamp; where no shadow rays are sent, the last bounce ray must find the lamp.
        paths.max_depth = scene.bounces + (searched ? 2 : 1);
    } else if (scene.bounces == 0) {
        unsaid.emplace_back(specular ? "diffuse surfaces beside mirrors, glass or lobes, with bounces = 0: Mitsuba "
                                       "limits both together; expected so many bounces that the rest is negligible"
                                     : "lamps with and without sampled = false, with bounces = 0; expected one kind");
    } else {
        paths.comment = fmt::format(
            "Paths have no limit here; Penumbra ends them after {} diffuse bounces, {} mirrors, glass "
            "and lobes. Diffuse albedo^(bounces + 1) is at most {:.2g}.",
            scene.bounces, scene.depth, std::pow(brightest, scene.bounces + 1));
    }
    return paths;
}

}  // namespace rt
