#include <cmath>
#include <cstdint>
#include <string>

#include "require.h"
#include "rt/files/scene_reader.h"
#include "rt/plan.h"

/// A scene file is a scene of finite numbers, or a located error.
namespace {

bool is_finite(rt::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    try {
        const rt::Scene scene = rt::parse_scene(text, "scenes/fuzz.toml");
        const rt::Camera& camera = scene.camera;
        require(is_finite(camera.eye) && is_finite(camera.right) && is_finite(camera.up) && is_finite(camera.back),
                "a camera that is not finite");
        require(camera.size.x > 0 && camera.size.y > 0 && camera.tan_half_fov > 0 && camera.focus > 0 &&
                    camera.lens_radius >= 0,
                "a camera that is none");
        require(scene.samples > 0 && scene.bounces >= 0 && scene.depth >= 0, "counts below 0");
        for (const rt::Shape& shape : scene.shapes) {
            require(shape.material >= 0 && std::size_t(shape.material) < scene.materials.size(),
                    "a shape without material");
            require(is_finite(shape.velocity), "a velocity that is not finite");
            if (const auto* sphere = std::get_if<rt::Sphere>(&shape.geometry))
                require(sphere->radius > 0 && is_finite(sphere->center), "a sphere that is none");
        }
        for (const rt::Material& m : scene.materials)
            require(is_finite(m.albedo) && is_finite(m.emission) && m.ior > 0, "a material that is none");
        for (const rt::PointLight& light : scene.lights)
            require(is_finite(light.position) && is_finite(light.intensity), "a light that is not finite");
        rt::make_plan(scene);
    } catch (const rt::InputError& error) {
        // "file:line:column: what is wrong"
        const std::string words = error.what();
        int line = 0, column = 0;
        const std::size_t colon = words.find(':');
        require(colon != words.npos && std::sscanf(words.c_str() + colon, ":%d:%d:", &line, &column) == 2 && line > 0 &&
                    column > 0,
                words.c_str());
    }
    return 0;
}
