#pragma once

#include "extremes/extremes.h"
#include "rt/files/scene_reader.h"
#include "rt/render.h"

/// Scenes as a whole: moved, scaled, drawn in small.

/// A scene of the project's, 32 x 32 pixels and 9 samples.
inline rt::Scene small_scene(const std::string& name) {
    rt::Scene scene = rt::read_scene("scenes/" + name + ".toml");
    scene.camera.size = {32, 32};
    scene.samples = 9;
    return scene;
}

inline rt::Image picture(const rt::Scene& scene, int threads = 1) {
    const rt::Rendering rendering = rt::render(
        scene, {.samples = scene.samples, .threads = threads, .sampler = scene.sampler, .estimate_error = false});
    CHECK(!rendering.bad_sample);
    return rendering.image;
}

/// How many pixels differ in any bit.
inline std::int64_t pixels_apart(const rt::Image& a, const rt::Image& b) {
    std::int64_t n = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) n += a.pixels[i] != b.pixels[i];
    return n;
}

/// Calls point(p) for each point, vector(v) for each length or velocity with a direction, length(x) for each without
/// one.
template <class Point, class Vector, class Length>
void transform(rt::Scene& s, Point point, Vector vector, Length length) {
    using namespace rt;
    s.camera.eye = point(s.camera.eye);
    s.camera.lens_radius = length(s.camera.lens_radius), s.camera.focus = length(s.camera.focus);
    for (PointLight& light : s.lights)
        if (!light.directional) light.position = point(light.position);
    for (Shape& shape : s.shapes) {
        shape.velocity = vector(shape.velocity);
        if (auto* q = std::get_if<Sphere>(&shape.geometry)) q->center = point(q->center), q->radius = length(q->radius);
        if (auto* q = std::get_if<Quad>(&shape.geometry))
            q->center = point(q->center), q->u = vector(q->u), q->v = vector(q->v);
        if (auto* q = std::get_if<Disc>(&shape.geometry)) q->center = point(q->center), q->radius = length(q->radius);
        if (auto* q = std::get_if<Triangle>(&shape.geometry))
            q->a = point(q->a), q->b = point(q->b), q->c = point(q->c);
    }
    for (Mesh& mesh : s.meshes) {
        mesh.velocity = vector(mesh.velocity);
        for (vec3& v : mesh.vertices) v = point(v);
    }
}

/// Everything `factor` times as large, and as bright: an intensity lights what is farther away.
inline rt::Scene scaled(rt::Scene scene, double factor) {
    const auto times = [factor](auto x) { return factor * x; };
    transform(scene, times, times, times);
    for (rt::PointLight& light : scene.lights)
        if (!light.directional) light.intensity *= factor * factor;
    for (rt::Material& m : scene.materials) m.medium.extinction /= factor;
    return scene;
}

/// Everything that shines, `factor` times as bright.
inline rt::Scene brighter(rt::Scene scene, double factor) {
    for (rt::PointLight& light : scene.lights) light.intensity *= factor;
    for (rt::Material& m : scene.materials) m.emission *= factor;
    scene.ambient *= factor, scene.environment *= factor, scene.background *= factor;
    return scene;
}
