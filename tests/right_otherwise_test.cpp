#include "explained.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A point anywhere on a sphere, which shines on one side: right, and no call is the solution's.
rt::LightSample on_sphere(const rt::Sphere& sphere, rt::vec3 p, rt::vec2 u) {
    const double z = 1 - 2 * u.x, r = rt::safe_sqrt(1 - z * z), turn = 2 * rt::pi * u.y;
    const rt::vec3 n(r * std::cos(turn), r * std::sin(turn), z), to = sphere.center + sphere.radius * n - p;
    const double distance = glm::length(to), cosine = -rt::dot(n, to) / distance;
    return {to / distance, distance,
            cosine > 0 ? distance * distance / (cosine * 4 * rt::pi * rt::sqr(sphere.radius)) : 0};
}

}  // namespace

TEST_CASE("lamps of a kind that are sampled in another way are not called wrong beside those that are") {
    Generator random(3);
    const Rows rows = rows_of(160, [](Generator& draw) {
        rt::Emitter lamp;
        lamp.kind = rt::Emitter::Kind(whole_between(draw, 0, 2));
        const rt::Frame frame = rt::frame_about(direction(draw));
        lamp.quad = {rt::vec3(0), between(draw, 0.2, 0.6) * frame.x, between(draw, 0.2, 0.6) * frame.y};
        lamp.disc = {rt::vec3(0), frame.z, between(draw, 0.2, 0.6)};
        lamp.sphere = {rt::vec3(0), between(draw, 0.3, 0.6)};
        return row(lamp, between(draw, 1, 3) * tilted(draw, frame.z, between(draw, 0, 0.8)), square(draw));
    })(random);
    const Ask mine = [](const Rows& asked) {
        Rows all = answers("light_sample")(asked);
        for (std::size_t k = 0; k < asked.size(); ++k) {
            RowReader in(asked[k]);
            const auto lamp = read(in, Tag<rt::Emitter>{});
            const auto p = read(in, Tag<rt::vec3>{});
            const auto u = read(in, Tag<rt::vec2>{});
            if (lamp.kind == rt::Emitter::Kind::sphere) all[k] = row(on_sphere(lamp.sphere, p, u));
            if (lamp.kind == rt::Emitter::Kind::quad) all[k].back() *= 4;  // its density
        }
        return all;
    };
    const Finding finding = found("light_sample", rows, mine);
    CHECK_THAT(finding.how, ContainsSubstring("`length(n)` in place of `4 * length(n)`"));
    CHECK(finding.how.find("other calls") == finding.how.npos);
    CHECK_THAT(finding.where, ContainsSubstring("`light.kind` is quad"));
    CHECK(finding.where.find("sphere") == finding.where.npos);
}

TEST_CASE("where samples may be in any order, the call that is shown breaks what is said") {
    Rows rows;
    Generator random(5);
    for (const int n : {4, 5, 6, 7, 9})
        for (int i = 0; i < n; ++i)
            for (int k = 0; k < 8; ++k) rows.push_back(row(i, n, square(random)));
    // rows first, and from the other corner, which are as good; and one row too few where n is no square
    for (const bool is_turned : {false, true}) {
        const Ask mine = [=](const Rows& asked) {
            Rows all;
            for (const Row& in : asked) {
                const int i = int(in[0]), n = int(in[1]), columns = std::max(1, int(std::sqrt(n))), lines = n / columns;
                const double x = (i % columns + in[2]) / columns, y = (i / columns + in[3]) / lines;
                all.push_back(is_turned ? Row{1 - x, 1 - y} : Row{x, y});
            }
            return all;
        };
        const Finding finding = found("stratified_2d", rows, mine);
        // one of both has a name
        CHECK_THAT(finding.how, ContainsSubstring(is_turned ? "between 0 and 1" : "cells of some n lie outside"));
        CHECK(finding.arguments.find("n = 4,") == finding.arguments.npos);
        CHECK(finding.arguments.find("n = 9,") == finding.arguments.npos);
        const auto second = finding.answer.find(", ");
        REQUIRE(second != finding.answer.npos);
        CHECK(std::abs(std::stod(finding.answer.substr(second + 2)) - 0.5) > 0.5);
    }
}
