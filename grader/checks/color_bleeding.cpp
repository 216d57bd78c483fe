#include "checks/fragment_checks.h"
#include "checks/probe_check.h"
#include "checks/warp.h"

namespace grade {

Checks check_color_bleeding(Generator& random) {
    using rt::Color, rt::Scattered, rt::vec3;
    const Color albedo(between(random, 0.6, 0.8), between(random, 0.35, 0.5), between(random, 0.1, 0.2));
    const vec3 normal = direction(random);
    const rt::Frame frame = rt::frame_about(normal);
    const auto inputs = [=](Generator& draws) {
        return repeat(rows_of(1024, [=](Generator& draw) { return row(normal, albedo, square(draw)); })(draws));
    };
    // mean of weight f(direction) = albedo x integral of f cos / pi, whatever the density
    const auto weighted = [](int channel, std::function<double(vec3)> f) {
        return [=](const Row&, const Row& out) {
            const Scattered s = from_row<Scattered>(out);
            return s.weight[channel] != 0 ? s.weight[channel] * f(s.direction) : 0.0;
        };
    };
    Statistic above = property("F1", "weight of directions below the surface",
        [=](const Row&, const Row& out) {
            const Scattered s = from_row<Scattered>(out);
            return rt::dot(s.direction, normal) < -1e-6 ? rt::largest(s.weight) : 0.0;
        },
        0, "light comes from below the surface: is the direction turned to the normal?");
    Statistic length = property("F1", "length of the direction, off 1 by",
        [](const Row&, const Row& out) { const Scattered s = from_row<Scattered>(out); return s.weight == Color(0) ? 0.0 : std::abs(glm::length(s.direction) - 1); }, 1e-4,
        "the direction is no unit vector");
    std::vector<Statistic> statistics = {above, length};
    const char* names[] = {"red", "green", "blue"};
    for (int k = 0; k < 3; ++k)
        statistics.push_back(mean_of("F2", std::string("mean weight, ") + names[k], weighted(k, [](vec3) { return 1.0; }), albedo[k], albedo[k],
            by_ratio("the light that is passed on", {{1 / albedo[k], "the albedo is missing"}, {albedo[k], "the albedo is squared"},
                                                     {albedo[(k + 1) % 3] / albedo[k], "the channels are exchanged"}, {albedo[(k + 2) % 3] / albedo[k], "the channels are exchanged"},
                                                     {2.0 / 3, "the cosine counts twice: it is in the density already"}, {0.5, "is the density that of another distribution?"}, {2, "is the hemisphere's density halved?"},
                                                     {rt::pi, "1/pi is missing"}, {1 / rt::pi, "1/pi counts twice"}, {0, "the path ends here: the weight is 0"}},
                     "the weight is albedo/pi x cosine / density")));
    statistics.push_back(mean_of("V3", "mean weight of the cosine, over its value", weighted(0, [=](vec3 d) { return rt::dot(d, normal) * 1.5 / albedo.x; }), 1, 1,
        by_ratio("the mean weight of the cosine", {{0.75, "the directions are uniform, but their weight is that of the cosine's density"}, {1.125, "the cosine counts twice"}},
                 "the directions are not those of the density in the weight")));
    for (const vec3 side : {frame.x, frame.y})
        statistics.push_back(mean_of("V3", "mean weight of the direction, sideways", weighted(0, [=](vec3 d) { return rt::dot(d, side) / albedo.x; }), 0, 0.5,
            always("the directions lean to one side: do angle and turn each use a number of their own?")));
    statistics.push_back(mean_of("V3", "mean weight of the squared direction, sideways", weighted(0, [=](vec3 d) { return rt::sqr(rt::dot(d, frame.x)) * 4 / albedo.x; }), 1, 1,
        always("the directions are not spread evenly round the normal")));
    statistics.push_back(purity());
    return {probe_check("next_ray", "color_bleeding", {"cosine_hemisphere"}, inputs, statistics)};
}

}  // namespace grade
