#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::vec2, rt::vec3;

/// A fragment that turns a local direction about an axis: its row for an axis, and for which axis that is.
struct Turning {
    std::string fragment;
    Row (*row_about)(vec3 axis, vec2 u);
};

Row bounce_row(vec3 axis, vec2 u) { return row(axis, rt::Color(0.5), u); }
Row scatter_row(vec3 axis, vec2 u) { return row(axis, 0.6, u); }
Row glossy_row(vec3 axis, vec2 u) { return row(-axis, axis, 20.0, u); }
Row translucent_row(vec3 axis, vec2 u) { return row(axis, -axis, 1.0, 1.5, 20.0, u); }
Row light_row(vec3 axis, vec2 u) {
    rt::Emitter light;
    light.kind = rt::Emitter::Kind::sphere, light.sphere = {3.0 * axis, 1};
    return row(light, vec3(0), u);
}

/// Directions about an axis that is x away from a pole of the coordinates: unit vectors and, where the fragment turns
/// the same direction about every axis, at the same angles to it as about axes far from the poles. Beyond ordinary
/// scenes also about the poles themselves.
auto poles(const Turning& turning) {
    return [=](double x, Generator& random, const Asker& ask) {
        std::vector<vec3> axes;
        for (int i = 0; i < 24; ++i) {
            vec3 pole(0);
            pole[2 - i / 2 % 3] = i % 2 ? 1 : -1;
            axes.push_back(x < 1e-3 && i < 6 ? pole : rt::unit(tilted(random, pole, x)));
        }
        const vec3 one = rt::unit(vec3(0.4, 0.5, 0.6)), two = rt::unit(vec3(-0.7, 0.4, 0.5));
        Rows rows, about_one, about_two;
        std::vector<vec3> about;
        for (const vec3 axis : axes)
            for (int k = 0; k < 8; ++k) {
                const vec2 u = square(random);
                rows.push_back(turning.row_about(axis, u));
                about_one.push_back(turning.row_about(one, u));
                about_two.push_back(turning.row_about(two, u));
                about.push_back(axis);
            }
        const auto cosine = [](const Row& out, vec3 axis) { return dot(vec3(out.at(0), out.at(1), out.at(2)), axis); };
        const Rows base = ask.probe(turning.fragment, about_one), other = ask.probe(turning.fragment, about_two);
        double turned = 0;
        for (std::size_t i = 0; i < rows.size(); ++i)
            turned = worse_error(turned, std::abs(cosine(base[i], one) - cosine(other[i], two)));
        return worst_of_rows(ask, turning.fragment, rows, [&](std::size_t i, const Row& out) {
            const vec3 d{out.at(0), out.at(1), out.at(2)};
            return worse_error(std::abs(glm::length(d) - 1),
                               turned < 1e-9 ? std::abs(dot(d, about[i]) - cosine(base[i], one)) : 0);
        });
    };
}

}  // namespace

std::vector<Family> frame_families() {
    std::vector<Family> all;
    for (const Turning& turning : {Turning{"color_bleeding", bounce_row}, Turning{"glossy_reflection", glossy_row},
                                   Turning{"translucency", translucent_row}, Turning{"light_sample", light_row},
                                   Turning{"scatter_direction", scatter_row}})
        all.push_back(Family("poles_" + turning.fragment, {turning.fragment}, "angle of the axis from a pole",
                             "error of length and angle",
                             {.bound = 32 * rt::roundoff, .decades = sweep(-16, -1), .scored = {-3, -1}},
                             poles(turning)));
    return all;
}

}  // namespace grade::stress
