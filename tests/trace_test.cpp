#include "rt/trace.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <sstream>

#include "catch.h"
#include "rt/files/scene_reader.h"

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> all_scenes() {
    std::vector<fs::path> scenes;
    for (const char* folder : {"scenes", "scenes/gallery"})
        for (const auto& entry : fs::directory_iterator(folder))
            if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

/// Some pixels of a small picture of a scene, two samples each.
template <class Check>
void for_pixels(const fs::path& file, Check check) {
    rt::Scene scene = rt::read_scene(file.string());
    scene.camera.size = {24, 16};
    scene.samples = 2;
    const rt::RenderSettings settings{.samples = scene.samples, .seed = 5, .estimate_error = false};
    for (const auto& [x, y] : {std::pair(12, 8), std::pair(5, 12), std::pair(17, 9), std::pair(8, 9), std::pair(12, 3)})
        check(scene, settings, x, y);
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// The vector that follows a word in a line.
bool vector_after(const std::string& line, const char* word, rt::vec3& v) {
    const auto at = line.find(word);
    return at != std::string::npos &&
           std::sscanf(line.c_str() + at + std::strlen(word), " (%lf, %lf, %lf)", &v.x, &v.y, &v.z) == 3;
}

}  // namespace

TEST_CASE("a trace tells of the picture's own light: what it says is added is the sample, and the mean is the pixel",
          "[trace]") {
    int lit = 0;
    for (const fs::path& file : all_scenes())
        for_pixels(file, [&](const rt::Scene& scene, rt::RenderSettings settings, int x, int y) {
            const rt::PixelTrace traced = rt::trace_paths(scene, settings, x, y);
            settings.crop = rt::Crop{x, y, 1, 1};
            INFO(file << " pixel " << x << ',' << y);
            CHECK(rt::render(scene, settings).image.pixels[0] == traced.mean);
            REQUIRE(traced.radiance.size() == traced.trace.samples.size());
            for (std::size_t k = 0; k < traced.radiance.size(); ++k) {
                const rt::Color told = traced.trace.samples[k].light, found = traced.radiance[k];
                INFO("sample " << k << " told " << told.x << ' ' << told.y << ' ' << told.z << " found " << found.x
                               << ' ' << found.y << ' ' << found.z << '\n'
                               << traced.trace.samples[k].text);
                const bool same = length(told - found) <= 1e-12 * length(found);
                CHECK(same);
                lit += found != rt::Color(0);
            }
        });
    CHECK(lit > 100);
}

TEST_CASE("what a trace prints as added makes up, to its six digits, what was gathered", "[trace]") {
    for (const fs::path& file : all_scenes())
        for_pixels(file, [&](const rt::Scene& scene, const rt::RenderSettings& settings, int x, int y) {
            const rt::PixelTrace traced = rt::trace_paths(scene, settings, x, y);
            for (const rt::Told& told : traced.trace.samples) {
                rt::vec3 sum(0), v, gathered(-1);
                for (const std::string& line : lines_of(told.text)) {
                    if (vector_after(line, "    adds              ", v)) sum += v;
                    vector_after(line, "  gathered            ", gathered);
                }
                INFO(file << '\n' << told.text);
                CHECK(length(sum - gathered) <= 1e-5 * length(gathered));
            }
        });
}

TEST_CASE("the direction that a fragment is told to answer is the one that the path takes", "[trace]") {
    std::map<std::string, int> seen;
    for (const fs::path& file : all_scenes())
        for_pixels(file, [&](const rt::Scene& scene, const rt::RenderSettings& settings, int x, int y) {
            if (rt::make_plan(scene).split) return;  // there rays of one wave follow each other
            for (const rt::Told& told : rt::trace_paths(scene, settings, x, y).trace.samples) {
                rt::vec3 from(0), direction(0), v;
                std::string fragment;
                for (const std::string& line : lines_of(told.text)) {
                    INFO(file << '\n' << told.text);
                    const std::string name = line.substr(2, line.find(' ', 2) - 2);
                    if (vector_after(line, "                      point", v)) {
                        if (!fragment.empty() && length(v - from) > 1e-3) {
                            CHECK(dot(v - from, direction) / length(v - from) > 1 - 1e-4);
                            ++seen[fragment];
                        }
                        from = v, fragment.clear();
                    }
                    for (const char* way : {"mirror_direction", "refracted_direction", "glossy_reflection",
                                            "translucency", "color_bleeding"})
                        if (name == way &&
                            (vector_after(line, "direction", direction) || vector_after(line, ":", direction) ||
                             vector_after(line, "mirror_direction   ", direction)))
                            fragment = name;
                    if (name == "scatter_direction") fragment.clear();
                }
            }
        });
    for (const char* way :
         {"mirror_direction", "refracted_direction", "glossy_reflection", "translucency", "color_bleeding"}) {
        INFO(way);
        CHECK(seen[way] > 0);
    }
}

TEST_CASE("a trace says of each point of a lamp whether its shadow ray arrives, and what is in the way", "[trace]") {
    const rt::Scene scene = rt::read_scene("scenes/penumbra.toml");
    const rt::RenderSettings settings{.samples = 4};
    std::string text;
    for (int x = 0; x < scene.camera.size.x; x += 8)
        text += rt::trace_pixel(scene, settings, x, scene.camera.size.y * 2 / 3);
    for (const char* words : {"camera_ray", "film_sample", "light_sample", "direct_light", "shadow_ray", ": arrives",
                              ": stopped by shape ", "density ", "distance ", "pixel_mean"}) {
        INFO(words);
        CHECK(text.find(words) != std::string::npos);
    }
}
