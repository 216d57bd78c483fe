/// How each way to sample lamps does, beside the plan's own: error and CPU seconds of one scene.
///
///     choices SCENE [SIDE]
///
/// One line of JSON: the ways that differ for this scene, and for each its mean squared errors and seconds at each
/// number of samples. One thread, all ways in turns. Errors are measured against two independent pictures, whose noise
/// adds nothing. Those "as_seen" are of pixels that are at most as bright as the brightest lamp, which no surface
/// outshines: where a lamp touches a surface, the variance is infinite, and a few pixels decide all other errors.

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "rt/files/scene_reader.h"
#include "rt/render.h"

using namespace rt;

namespace {

constexpr int levels[] = {4, 16, 64};
constexpr int rounds = 3;

struct Way {
    std::string name;
    Scene scene;
    std::vector<double> errors[std::size(levels)], as_seen[std::size(levels)], seconds[std::size(levels)];
};

/// What a plan decides about lamps.
std::string name_of(const RenderPlan& plan) {
    return std::string(plan.solid_angle ? "angle" : "area") + (plan.one_lamp ? " one" : " all") +
           (plan.weigh ? " weighed" : "");
}

/// All ways that the scene's plan tells apart.
std::vector<Way> ways_of(const Scene& scene) {
    std::vector<Way> ways;
    for (int options = 0; options < 8; ++options) {
        Scene forced = scene;
        forced.solid_angle = (options & 1) != 0, forced.one_lamp = (options & 2) != 0;
        forced.multiple_importance = (options & 4) != 0;
        const std::string name = name_of(make_plan(forced));
        if (std::none_of(ways.begin(), ways.end(), [&](const Way& way) { return way.name == name; }))
            ways.push_back({name, forced, {}, {}, {}});
    }
    return ways;
}

Rendering picture(const Scene& scene, Sampler sampler, int samples, std::uint64_t seed) {
    return render(scene, {.samples = samples, .seed = seed, .threads = 1, .sampler = sampler, .estimate_error = false});
}

/// The mean of (a - one) (a - other), of pixels up to the most.
double squared_error(const Image& a, const Image& one, const Image& other, Color most = Color(inf)) {
    double sum = 0;
    for (std::size_t k = 0; k < a.pixels.size(); ++k) {
        const Color pixel = glm::min(a.pixels[k], most);
        sum += dot(pixel - glm::min(one.pixels[k], most), pixel - glm::min(other.pixels[k], most)) / 3;
    }
    return sum / double(a.pixels.size());
}

Color brightest(const Scene& scene) {
    if (!scene.lights.empty()) return Color(inf);
    Color most = glm::max(scene.background, scene.environment);
    for (const Material& m : scene.materials) most = glm::max(most, m.emission);
    return most;
}

double median(std::vector<double> x) {
    std::sort(x.begin(), x.end());
    return x[x.size() / 2];
}

void print_list(const char* name, const std::vector<double>* values, double (*of)(std::vector<double>)) {
    std::printf("\"%s\": [", name);
    for (std::size_t l = 0; l < std::size(levels); ++l) std::printf("%s%.6g", l ? ", " : "", of(values[l]));
    std::printf("]");
}

double mean(std::vector<double> x) {
    double sum = 0;
    for (const double v : x) sum += v / double(x.size());
    return sum;
}

}  // namespace

int main(int count, char** words) {
    Scene scene = read_scene(words[1]);
    const int side = count > 2 ? std::atoi(words[2]) : 64;
    scene.camera.size = {side, side};
    std::vector<Way> ways = ways_of(scene);
    const Scene& best = ways.back().scene;
    const Image one = picture(best, Sampler::sobol, 256, 101).image,
                other = picture(best, Sampler::sobol, 256, 102).image;
    const Color most = brightest(scene);
    const Image random = picture(ways[0].scene, Sampler::random, 64, 1).image;
    for (int round = 0; round < rounds; ++round)
        for (std::size_t l = 0; l < std::size(levels); ++l)
            for (Way& way : ways) {
                const Rendering r = picture(way.scene, scene.sampler, levels[l], std::uint64_t(10 + round));
                way.errors[l].push_back(squared_error(r.image, one, other));
                way.as_seen[l].push_back(squared_error(r.image, one, other, most));
                way.seconds[l].push_back(r.cpu_seconds);
            }
    std::printf("{\"plan\": \"%s\", \"plain\": {\"errors\": %.6g, \"as_seen\": %.6g}, \"ways\": {",
                name_of(make_plan(scene)).c_str(), squared_error(random, one, other),
                squared_error(random, one, other, most));
    for (std::size_t k = 0; k < ways.size(); ++k) {
        std::printf("%s\"%s\": {", k ? ", " : "", ways[k].name.c_str());
        print_list("errors", ways[k].errors, mean);
        std::printf(", ");
        print_list("as_seen", ways[k].as_seen, mean);
        std::printf(", ");
        print_list("seconds", ways[k].seconds, median);
        std::printf("}");
    }
    std::printf("}}\n");
}
