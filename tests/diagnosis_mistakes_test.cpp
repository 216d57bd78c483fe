#include "explained.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("a mistake in the middle of a formula is named, in the words of its documentation") {
    const Rows indices = calls(
        [](Generator& random) { return row(between(random, 0.05, 1), between(random, 1, 2), between(random, 1, 2)); });
    const Ask no_square = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const double c1 = in[0], e1 = in[1], e2 = in[2], squared = 1 - e1 / e2 * (1 - c1 * c1);
            const double c2 = std::sqrt(std::max(squared, 0.0));
            const double s = (e1 * c1 - e2 * c2) / (e1 * c1 + e2 * c2), p = (e2 * c1 - e1 * c2) / (e2 * c1 + e1 * c2);
            all.push_back({squared < 0 ? 1 : e1 == e2 ? 0 : (s * s + p * p) / 2});
        }
        return all;
    };
    CHECK_THAT(found("fresnel_dielectric", indices, no_square).how,
               ContainsSubstring(
                   "`e` in place of `e * e`, where a textbook has `squared = 1 - e * e * (1 - cosine * cosine)`"));
}

TEST_CASE("a sign in the middle of a formula is named, also where the answer is normalised afterwards") {
    const Ask negated = answers("refracted_direction", {}, {});
    const Rows rays = calls([](Generator& random) {
        const rt::vec3 n = direction(random);
        return row(-tilted(random, n, 0.3), n, between(random, 1, 1.4), between(random, 1.4, 2));
    });
    const Ask sign = [negated](const Rows& asked) {
        Rows all = negated(asked);
        for (std::size_t k = 0; k < asked.size(); ++k) {
            const rt::vec3 d(asked[k][0], asked[k][1], asked[k][2]), n(asked[k][3], asked[k][4], asked[k][5]);
            const double twice = 2 * asked[k][6] / asked[k][7] * rt::dot(d, n);
            for (int c = 0; c < 3; ++c) all[k][std::size_t(c)] += twice * n[c];
        }
        return all;
    };
    CHECK_THAT(found("refracted_direction", rays, sign).how,
               ContainsSubstring("where a textbook has `c = -dot(d, n)`"));
    const Ask normalised = [sign](const Rows& asked) {
        Rows all = sign(asked);
        for (Row& one : all) {
            const rt::vec3 v = rt::unit({one[0], one[1], one[2]});
            one = row(v);
        }
        return all;
    };
    CHECK_THAT(found("refracted_direction", rays, normalised).how,
               ContainsSubstring("where a textbook has `c = -dot(d, n)`"));
}

TEST_CASE("what calls that are no number have in common is told in variables of the formula") {
    const Rows rays = calls([](Generator& random) {
        const rt::vec3 n = direction(random);
        return row(-tilted(random, n, between(random, 0, 1.5)), n, between(random, 1, 2), between(random, 1, 2));
    });
    const Ask no_test = answers("refracted_direction", {}, [](Row& out) {
        if (out[0] == 0 && out[1] == 0 && out[2] == 0) out[0] = out[1] = out[2] = std::nan("");
    });
    CHECK_THAT(found("refracted_direction", rays, no_test).where,
               ContainsSubstring("are nan, those where `squared < 0`, with `squared = 1 - e * e * (1 - c * c)`"));
}

TEST_CASE("that a length is taken to be 1 is told as such") {
    const Rows spheres = calls([](Generator& random) {
        const rt::Sphere sphere{box(random, -1, 1), between(random, 0.5, 1)};
        const rt::vec3 origin = sphere.center + between(random, 2, 5) * direction(random);
        const double length = chance(random, 0.5) ? 1 : between(random, 0.2, 3);
        return row(sphere, rt::Ray{origin, length * rt::unit(sphere.center - origin)});
    });
    // no formula with |d| = 1, but right for it alone
    const Ask of_unit_length = [](const Rows& rows) {
        Rows all = answers("hit_sphere")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const double length = glm::length(rt::vec3(rows[k][7], rows[k][8], rows[k][9]));
            all[k][0] += 0.3 * std::sin(7 * (length - 1));
        }
        return all;
    };
    CHECK_THAT(found("hit_sphere", spheres, of_unit_length).how,
               ContainsSubstring("the length of `ray.direction` is taken to be 1"));
    // the textbook's formula, of which it is a step
    const Ask without_a = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const rt::vec3 f = rt::vec3(in[4], in[5], in[6]) - rt::vec3(in[0], in[1], in[2]), d(in[7], in[8], in[9]);
            const double b = rt::dot(f, d), c = rt::dot(f, f) - in[3] * in[3], squared = b * b - c;
            const double t = -b - std::sqrt(squared);
            all.push_back({squared >= 0 && t > in[10] && t < in[11] ? t : rt::inf});
        }
        return all;
    };
    CHECK_THAT(found("hit_sphere", spheres, without_a).how,
               ContainsSubstring("`unit(ray.direction)` in place of `ray.direction`, where a textbook has `speed"));
}

TEST_CASE("a mistake by which every ray misses is found by rays that start near the shape") {
    const Rows rays = calls([](Generator& random) {
        const rt::Triangle triangle{box(random, -1, 1), box(random, -1, 1), box(random, -1, 1)};
        const rt::vec3 to = (triangle.a + triangle.b + triangle.c) / 3.0, origin = 4.0 * direction(random);
        return row(triangle, rt::Ray{origin, to - origin});
    });
    const Ask reversed = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const auto at = [&](std::size_t i) { return rt::vec3(in[i], in[i + 1], in[i + 2]); };
            const rt::vec3 e1 = at(3) - at(0), e2 = at(6) - at(0), s = at(9) - at(0), d = at(12);
            const rt::vec3 p = rt::cross(d, e2), q = rt::cross(e1, s);
            const double det = rt::dot(e1, p), u = rt::dot(s, p) / det, v = rt::dot(d, q) / det,
                         t = rt::dot(e2, q) / det;
            all.push_back({u >= 0 && v >= 0 && u + v <= 1 && t > in[15] && t < in[16] ? t : rt::inf});
        }
        return all;
    };
    CHECK_THAT(found("hit_triangle", rays, reversed).how,
               ContainsSubstring(
                   "`cross(e2, ray.direction)` in place of `cross(ray.direction, e2)`, where a textbook has `p = ") &&
                   ContainsSubstring(
                       ", or `cross(e1, s)` in place of `cross(s, e1)`, where a textbook has `q = cross(s, e1)`"));
}

TEST_CASE("a condition that always holds is told as such, not as another value in it") {
    const Rows rays = calls([](Generator& random) {
        const rt::Sphere sphere{box(random, -1, 1), between(random, 0.5, 1)};
        const rt::vec3 origin = sphere.center + between(random, 0, 2) * direction(random);
        return row(sphere, rt::Ray{origin, direction(random), 0, between(random, 0.3, 3)});
    });
    const Ask far_of_near_root_alone = [](const Rows& rows) {
        Rows all = answers("hit_sphere")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const rt::vec3 f =
                rt::vec3(rows[k][4], rows[k][5], rows[k][6]) - rt::vec3(rows[k][0], rows[k][1], rows[k][2]);
            const double b = rt::dot(f, rt::vec3(rows[k][7], rows[k][8], rows[k][9]));
            const double far = -b + std::sqrt(b * b - rt::dot(f, f) + rows[k][3] * rows[k][3]);
            if (all[k][0] == rt::inf && far > 0) all[k][0] = far;
        }
        return all;
    };
    CHECK_THAT(found("hit_sphere", rays, far_of_near_root_alone).how,
               ContainsSubstring("`t1 > ray.near` in place of `t1 > ray.near && t1 < ray.far`"));
}

TEST_CASE("another function in place of one is named") {
    const Ask mine = [](const Rows& rows) {
        Rows all = answers("phong_lobe")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const double sine = std::sqrt(std::max(0.0, 1 - all[k][2] * all[k][2]));
            all[k][1] = sine * std::cos(2 * rt::pi * rows[k][2]);
        }
        return all;
    };
    const Rows lobes = calls([](Generator& random) { return row(between(random, 1, 30), square(random)); });
    CHECK_THAT(found("phong_lobe", lobes, mine).how,
               ContainsSubstring("`cos(phi)` in place of `sin(phi)`, where a textbook has `sine * sin(phi)`"));
}

TEST_CASE("of several alike in one statement it is told which") {
    const Rows times = calls([](Generator& random) {
        const double open = between(random, 0.1, 1);
        return row(open, open + between(random, 0.1, 1), between(random, 0, 1));
    });
    const Ask by_closing = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) all.push_back({in[0] + in[2] * (in[1] - in[0] / 2)});
        return all;
    };
    CHECK_THAT(found("shutter_time", times, by_closing).how,
               ContainsSubstring("`shutter.open / 2` in place of the second `shutter.open`, where a textbook has "
                                 "`shutter.open + u * (shutter.close"));
}

TEST_CASE("parts of an answer that have a mistake each are told one after the other") {
    const Ask both =
        answers("cosine_hemisphere", {}, [](Row& answer) { std::swap(answer[0], answer[1]), answer[3] *= 2; });
    const std::string how = found("cosine_hemisphere", squares(), both).how;
    CHECK_THAT(how, ContainsSubstring("`direction`") && ContainsSubstring("`density` is 2 times too large"));
}

TEST_CASE("a shadow ray that starts on the surface is told so, whatever else differs; one with an epsilon is not") {
    const Rows rows = calls([](Generator& random) {
        const rt::vec3 n = direction(random), point = box(random, -3, 3);
        return row(rt::Hit{point, n, 1e-14}, tilted(random, n, between(random, 0.1, 1.4)), between(random, 0.5, 5));
    });
    const auto mine = [](double near, double varying) {
        return [=](const Rows& asked) {
            Rows all = answers("shadow_ray")(asked);
            for (std::size_t k = 0; k < asked.size(); ++k) {
                for (std::size_t c = 0; c < 3; ++c) all[k][c] = asked[k][c];
                all[k][6] = near + varying * asked[k].back();
            }
            return all;
        };
    };
    const auto is_told = ContainsSubstring("the ray starts on the surface");
    CHECK_THAT(found("shadow_ray", rows, mine(0, 0)).how, is_told);
    CHECK_THAT(found("shadow_ray", rows, mine(0, 1e-9)).how, is_told);
    CHECK_THAT(found("shadow_ray", rows, mine(1e-3, 0)).how, !is_told);
    CHECK(found("shadow_ray", rows, answers("shadow_ray")).how.empty());
}
