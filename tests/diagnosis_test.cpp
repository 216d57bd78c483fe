#include <array>
#include <fstream>
#include <iterator>
#include <random>
#include <regex>

#include "catch.h"
#include "checks/kit/draw.h"
#include "checks/kit/probe_check.h"
#include "child/probes.h"
#include "diagnosis/diagnosis.h"
#include "diagnosis/explain.h"
#include "diagnosis/sanitizer.h"
#include "diagnosis/steps.h"
#include "protocol/rows.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string header() {
    std::ifstream file("starter/rt/fragments.h");
    return {std::istreambuf_iterator<char>(file), {}};
}

Signature declared(const std::string& fragment) { return signature_of(fragment, header()).value(); }

/// The answers of the solution, or of it with a mistake: made of its arguments, or of its answer.
Ask answers(const std::string& fragment, std::function<void(Row&)> arguments = {},
            std::function<void(Row&)> answer = {}) {
    return [=](const Rows& rows) {
        Rows all;
        for (Row row : rows) {
            if (arguments) arguments(row);
            Row out = probe(fragment, row);
            if (answer) answer(out);
            all.push_back(out);
        }
        return all;
    };
}

Finding found(const std::string& fragment, const Rows& rows, const Ask& mine) {
    return explain(declared(fragment), rows, mine, answers(fragment));
}

/// So many calls, each drawn anew.
template <class F>
Rows calls(F draw, int count = 60) {
    Generator random(3);
    return rows_of(count, draw)(random);
}

Rows mirrors() {
    return calls([](Generator& random) { return row(box(random, -3, 3), direction(random)); });
}

Rows squares() {
    return calls([](Generator& random) { return row(square(random)); });
}

}  // namespace

TEST_CASE("each declaration of fragments.h is read, and says what a row of it holds") {
    const std::string text = header();
    const std::regex declaration("^[A-Za-z]\\S* ([a-z_0-9]+)\\(.*\\);$", std::regex::multiline);
    int count = 0;
    for (auto found = std::sregex_iterator(text.begin(), text.end(), declaration); found != std::sregex_iterator();
         ++found) {
        const std::string name = (*found)[1];
        if (name == "report_not_started") continue;
        const Signature signature = declared(name);
        const Row blank = signature.blank();
        INFO(name);
        CHECK_FALSE(signature.arguments.empty());
        CHECK_NOTHROW(signature.of_arguments(blank));
        CHECK_THROWS(signature.of_arguments(Row(blank.begin(), blank.end() - 1)));
        if (signature.of_arguments(blank).lists.empty() && signature.arguments[0].type != "Function")
            CHECK_NOTHROW(probe(name, blank));
        ++count;
    }
    CHECK(count > 30);
}

TEST_CASE("arguments are printed by name, without those at their defaults, and read again") {
    const Signature camera = declared("camera_ray");
    rt::Camera some;
    some.size = {2, 2}, some.focus = rt::inf;
    const Row told = row(some, rt::vec2(0, 0.5));
    CHECK(arguments_in_words(camera, told) == "camera.size = (2, 2), film = (0, 0.5)");
    CHECK(arguments_from_words(camera, arguments_in_words(camera, told)) == told);
    std::vector<bool> always(camera.of_arguments(told).parts.size());
    always[7] = true;
    CHECK_THAT(arguments_in_words(camera, told, {{}, always}), ContainsSubstring("camera.focus = inf"));
    CHECK_THROWS_WITH(arguments_from_words(camera, "camera.size = 2"),
                      ContainsSubstring("camera.size is 1 numbers; expected 2"));
    CHECK_THROWS_WITH(arguments_from_words(camera, "size = (2, 2)"), ContainsSubstring("camera.tan_half_fov"));
    const Signature light = declared("light_sample");
    CHECK_THAT(arguments_in_words(light, arguments_from_words(light, "light.kind = disc, p = (0, 0, 1)")),
               ContainsSubstring("light.kind = disc"));
}

TEST_CASE("a mistake in the arguments of any formula is named") {
    const auto exchanged = [](Row& in) { std::swap_ranges(in.begin(), in.begin() + 3, in.begin() + 3); };
    CHECK_THAT(found("mirror_direction", mirrors(), answers("mirror_direction", exchanged)).how,
               ContainsSubstring("`d` and `n` exchanged"));
    const auto one_number = [](Row& in) { in[1] = in[0]; };
    CHECK_THAT(found("cosine_hemisphere", squares(), answers("cosine_hemisphere", one_number)).how,
               ContainsSubstring("`u.x` in place of `u.y`: one number is used for both"));
    const auto no_root = [](Row& in) { in[0] *= in[0]; };
    CHECK_THAT(found("uniform_disk", squares(), answers("uniform_disk", no_root)).how,
               ContainsSubstring("`u.x * u.x` in place of `u.x`"));
    const auto two = [](Row& in) { in[0] = std::sqrt(in[0]), in[1] /= 2; };
    const std::string both = found("uniform_disk", squares(), answers("uniform_disk", two)).how;
    CHECK_THAT(both, ContainsSubstring("`sqrt(u.x)`"));
    CHECK_THAT(both, ContainsSubstring("`u.y / 2`"));
}

TEST_CASE("the steps of a formula make the solution's answers, and each step that may be changed changes one") {
    std::size_t formulas = 0;
    std::ifstream file("starter/rt/fragments.h");
    const std::regex declaration("^[A-Za-z0-9]+ ([a-z_0-9]+)\\(.*\\);$");
    std::smatch found;
    for (std::string line; std::getline(file, line);) {
        if (!std::regex_match(line, found, declaration)) continue;
        const std::string name = found[1];
        Generator random(7);
        Rows rows;
        for (const Check& check : checks_of(name, 7))
            if (const auto* one = std::get_if<Probe>(&check.experiment))
                for (Row& row : one->inputs(random)) rows.push_back(std::move(row));
        for (const Steps& steps : steps_of(name)) {
            INFO(name << " " << steps.formula);
            std::size_t close = 0;
            bool moves = false;
            for (const Row& row : rows) {
                const Row right = probe(name, row), taken = steps.take(row);
                Row all = row;
                all.insert(all.end(), taken.begin(), taken.end());
                const Row answer = steps.finish(all);
                const auto equal = [](double x, double y) {
                    return x == y || std::abs(x - y) <= 1e-4 * std::max(1.0, std::abs(y));
                };
                close +=
                    answer.size() <= right.size() && std::equal(answer.begin(), answer.end(), right.begin(), equal);
                for (std::size_t i = row.size(); i < all.size() && !moves; ++i) {
                    Row other = all;
                    other[i] = 0.7 * other[i] + 1;
                    moves = steps.finish(other) != answer;
                }
            }
            CHECK(double(close) > 0.9 * double(rows.size()));
            CHECK(moves);
            ++formulas;
        }
    }
    CHECK(formulas > 40);
}

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
               ContainsSubstring("`sqrt(e^2)` in place of `e^2`") && ContainsSubstring("c2 = sqrt("));
    const Rows strata = calls([](Generator& random) {
        std::vector<StratumOf> list;
        for (int k = 0; k < 3; ++k) list.push_back({0.3 * k * k, 0.3 * (k + 1) * (k + 1), {}});
        for (StratumOf& own : list)
            for (int i = 0; i < 3; ++i) own.u.push_back(between(random, 0, 1));
        return row(Integrand{Integrand::Kind::polynomial, {between(random, 1, 2), between(random, 1, 2)}}, list);
    });
    const Ask never_reset = [](const Rows& rows) {
        Rows all = answers("integrate_stratified")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const double c0 = rows[k][2], c1 = rows[k][3];
            double total = 0, sum = 0;
            for (std::size_t at = 5; at < rows[k].size(); at += 6) {
                const double low = rows[k][at], width = rows[k][at + 1] - low;
                for (std::size_t i = 0; i < 3; ++i) sum += c0 + c1 * (low + rows[k][at + 3 + i] * width);
                total += width * sum / 3;
            }
            all[k][0] = total;
        }
        return all;
    };
    CHECK_THAT(found("integrate_stratified", strata, never_reset).how, ContainsSubstring("not set back to 0"));
    const Ask first_alone = [](const Rows& rows) {
        Rows all = answers("integrate_stratified")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            double total = 0;
            for (std::size_t at = 5; at < rows[k].size(); at += 6) {
                const double low = rows[k][at], width = rows[k][at + 1] - low;
                total += width * (rows[k][2] + rows[k][3] * (low + rows[k][at + 3] * width));
            }
            all[k][0] = total;
        }
        return all;
    };
    CHECK_THAT(found("integrate_stratified", strata, first_alone).how,
               ContainsSubstring("the first u of each stratum alone"));
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
    CHECK_THAT(found("refracted_direction", rays, sign).how, ContainsSubstring("`-e * c` in place of `e * c`"));
    const Ask normalised = [sign](const Rows& asked) {
        Rows all = sign(asked);
        for (Row& one : all) {
            const rt::vec3 v = rt::unit({one[0], one[1], one[2]});
            one = row(v);
        }
        return all;
    };
    CHECK_THAT(found("refracted_direction", rays, normalised).how,
               ContainsSubstring("`-e * c` in place of `e * c`") && ContainsSubstring("in `unit("));
}

TEST_CASE("what calls that are no number have in common is told in steps of the formula") {
    const Rows rays = calls([](Generator& random) {
        const rt::vec3 n = direction(random);
        return row(-tilted(random, n, between(random, 0, 1.5)), n, between(random, 1, 2), between(random, 1, 2));
    });
    const Ask no_test = answers("refracted_direction", {}, [](Row& out) {
        if (out[0] == 0 && out[1] == 0 && out[2] == 0) out[0] = out[1] = out[2] = std::nan("");
    });
    CHECK_THAT(found("refracted_direction", rays, no_test).where,
               ContainsSubstring("are nan, those where `1 - e^2 * (1 - c^2) < 0`"));
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
    CHECK_THAT(found("hit_sphere", spheres, without_a).how, ContainsSubstring("`1` in place of `a`"));
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
    CHECK_THAT(found("hit_triangle", rays, reversed).how, ContainsSubstring("`-q` in place of `q`"));
}

TEST_CASE("of a sum it is told which values it takes, and how often") {
    const Rows sums = calls([](Generator& random) {
        const Integrand f{Integrand::Kind::polynomial, {between(random, 1, 2), between(random, 1, 2)}};
        return row(f, between(random, -1, 0), between(random, 1, 2), whole_between(random, 2, 9));
    });
    const Ask half_the_first = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            RowReader reader(in);
            const auto f = read(reader, Tag<Integrand>{});
            const double a = in[in.size() - 3], step = (in[in.size() - 2] - a) / in.back();
            double sum = 0;
            for (int i = 0; i < in.back(); ++i) sum += (i == 0 ? 0.5 : 1) * step * f(a + (i + 0.5) * step);
            all.push_back(answers("integrate_uniform")({in}).front());
            all.back()[0] = sum;
        }
        return all;
    };
    CHECK_THAT(found("integrate_uniform", sums, half_the_first).how,
               ContainsSubstring("the sum is 0.5 * f(0.5) + f(1.5) + f(2.5); it must be f(0.5) + f(1.5) + f(2.5)"));
}

TEST_CASE("parts of an answer that have a mistake each are told one after the other") {
    const Ask both =
        answers("cosine_hemisphere", {}, [](Row& answer) { std::swap(answer[0], answer[1]), answer[3] *= 2; });
    const std::string how = found("cosine_hemisphere", squares(), both).how;
    CHECK_THAT(how, ContainsSubstring("`direction`") && ContainsSubstring("`density` is 2 times too large"));
}

TEST_CASE("directions that are spread in a usual way are told as such") {
    const Ask isotropic = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const double z = 1 - 2 * in[5], sine = std::sqrt(std::max(0.0, 1 - z * z)), g = in[3];
            const rt::vec2 circle = rt::unit_circle(in[4]);
            const rt::vec3 to{sine * circle.x, z, sine * circle.y};
            const double base = 1 + g * g - 2 * g * rt::dot(to, rt::vec3(in[0], in[1], in[2]));
            all.push_back(row(rt::DirectionSample{to, (1 - g * g) / (4 * rt::pi * base * std::sqrt(base))}));
        }
        return all;
    };
    const Rows scattered =
        calls([](Generator& random) { return row(direction(random), between(random, 0.3, 0.8), square(random)); });
    CHECK_THAT(found("scatter_direction", scattered, isotropic).how,
               ContainsSubstring("the directions are uniform on the whole sphere"));
}

namespace {

/// Lamps of any kind, seen from any side.
Rows lamps(int count = 200) {
    return calls(
        [](Generator& random) {
            rt::Emitter lamp;
            lamp.kind = rt::Emitter::Kind(whole_between(random, 0, 2));
            const rt::Frame frame = rt::frame_about(direction(random));
            lamp.quad = {box(random, -2, 2), between(random, 0.1, 0.3) * frame.x, between(random, 0.1, 0.3) * frame.y};
            lamp.disc = {lamp.quad.center, frame.z, between(random, 0.1, 0.3)};
            lamp.sphere = {lamp.quad.center, between(random, 0.1, 0.3)};
            return row(lamp, lamp.quad.center + between(random, 1, 3) * direction(random), square(random));
        },
        count);
}

/// The solution's samples of lamps, with another density, made of the cosine at the lamp.
template <class Density>
Ask with_density(Density density) {
    return [=](const Rows& rows) {
        Rows all = answers("light_sample")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            RowReader reader(rows[k]);
            const auto lamp = read(reader, Tag<rt::Emitter>{});
            if (lamp.kind == rt::Emitter::Kind::sphere) continue;
            const rt::vec3 d(all[k][0], all[k][1], all[k][2]);
            const double cosine = -rt::dot(d, rt::unit(rt::normal(lamp)));
            all[k][4] = density(lamp, cosine, rt::sqr(all[k][3]) / rt::area(lamp));
        }
        return all;
    };
}

}  // namespace

TEST_CASE("where nothing comes, nobody must look somewhere: only the density is told, of a call in which it is wrong") {
    const Ask both_sides =
        with_density([](const rt::Emitter&, double cosine, double squared) { return squared / std::abs(cosine); });
    const Ask elsewhere = [both_sides](const Rows& rows) {
        Rows all = both_sides(rows), right = answers("light_sample")(rows);
        for (std::size_t k = 0; k < all.size(); ++k)
            if (right[k][4] == 0) all[k][0] = all[k][1] = 0, all[k][2] = 1, all[k][3] = 7;
        return all;
    };
    for (const Ask& mine : {both_sides, elsewhere}) {
        const Finding finding = found("light_sample", lamps(), mine);
        CHECK_THAT(finding.where, ContainsSubstring("those where the right density is 0"));
        CHECK(finding.answer.starts_with("density = "));
        CHECK(finding.right == "density = 0");
    }
    CHECK_THAT(found("light_sample", lamps(), both_sides).how, ContainsSubstring("`abs(cos)` in place of `cos`"));
}

TEST_CASE("of a lamp of one kind, the others' fields are not told") {
    const Ask no_cosine = with_density([](const rt::Emitter& lamp, double cosine, double squared) {
        return cosine > 0 ? squared / (lamp.kind == rt::Emitter::Kind::quad ? 1 : cosine) : 0;
    });
    const std::string how = found("light_sample", lamps(), no_cosine).how;
    CHECK_THAT(how, ContainsSubstring("where `light.kind` is quad, ") && ContainsSubstring("`1` in place of `cos"));
    CHECK(how.find("disc") == how.npos);
    const Ask whole_edges = [](const Rows& rows) {
        Rows moved = rows;
        for (Row& in : moved)
            if (in[0] == 0)
                for (const std::size_t at : {in.size() - 2, in.size() - 1}) in[at] = (1 + in[at]) / 2;
        return answers("light_sample")(moved);
    };
    const Finding quarter = found("light_sample", lamps(), whole_edges);
    CHECK_THAT(quarter.how, ContainsSubstring("u in place of 2 * u - 1, which covers a quarter of the quad") &&
                                ContainsSubstring("in `of a quad, point = "));
    CHECK_THAT(quarter.where, ContainsSubstring("`light.kind` is quad"));
    CHECK(quarter.how.find("disc") == quarter.how.npos);
}

TEST_CASE("a change that spoils right calls is no cause") {
    const Rows cells = calls([](Generator& random) {
        const int n = std::array{4, 5, 9, 11}[std::size_t(whole_between(random, 0, 3))];
        return row(whole_between(random, 0, n - 1), n, square(random));
    });
    // as wide as each other, whatever they hold
    const Ask equal_columns = [](const Rows& rows) {
        Rows all = answers("stratified_2d")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const double n = rows[k][1], columns = std::floor(std::sqrt(n)),
                         column = std::floor(rows[k][0] * columns / n);
            all[k][0] = (column + rows[k][2]) / columns;
        }
        return all;
    };
    const std::string how = found("stratified_2d", cells, equal_columns).how;
    CHECK_THAT(how, ContainsSubstring("`column / columns` in place of `left`") &&
                        ContainsSubstring("`1 / columns` in place of `width`"));
    CHECK(how.find("`n + 1`") == how.npos);
}

TEST_CASE("the sign of what is 0 elsewhere is told") {
    const Rows rays = calls([](Generator& random) {
        const rt::vec3 n = direction(random);
        return row(-tilted(random, n, between(random, 0, 1.5)), n, 1.5, 1.0, 3.0, square(random));
    });
    const Ask negative = [](const Rows& rows) {
        Rows all = answers("translucency")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (all[k][3] == 0)
                all[k] = row(rt::Scattered{rt::vec3(0, 0, 1), rt::Color(0)});
            else
                for (std::size_t c = 3; c < 6; ++c) all[k][c] *= -1;
        return all;
    };
    CHECK(found("translucency", rays, negative).how == "`weight` has the opposite sign");
}

TEST_CASE("the example keeps an order that all calls have, equal ends among them") {
    const Rows shutters = calls([](Generator& random) {
        const double open = box(random, -5, 5).x;
        return row(rt::Shutter{open, chance(random, 0.2) ? open : open + between(random, 0, 3)}, between(random, 0, 1));
    });
    const Ask to_close = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) all.push_back({in[0] + in[2] * in[1]});
        return all;
    };
    const std::string arguments = found("shutter_time", shutters, to_close).arguments;
    INFO(arguments);
    CHECK(arguments.find("shutter.close = ") != std::string::npos);
}

TEST_CASE("a sign that is wrong in all of a sample is told of all, not of its density alone") {
    const Rows scattered = calls([](Generator& random) {
        return row(direction(random), between(random, -0.9, 0.9),
                   rt::vec2(between(random, 0, 1), between(random, 0, 1)));
    });
    const Ask other_way = [](const Rows& rows) {
        Rows turned = rows;
        for (Row& in : turned) in[3] *= -1;
        return answers("scatter_direction")(turned);
    };
    CHECK(found("scatter_direction", scattered, other_way).how ==
          "the answers are exactly what the right fragment answers with `-g` in place of `g`");
}

TEST_CASE("an offset that is small beside the answer is told") {
    const Rows hits = calls([](Generator& random) {
        const rt::vec3 n = direction(random);
        return row(rt::Hit{box(random, -5, 5), n, 1e-14}, tilted(random, n, 0.5), between(random, 1, 9));
    });
    const Ask above = [](const Rows& rows) {
        Rows all = answers("shadow_ray")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c) all[k][c] = rows[k][c] + 1e-4 * rows[k][3 + c];
        return all;
    };
    CHECK(found("shadow_ray", hits, above).how == "`origin` is off by `0.0001 * hit.normal`");
}

TEST_CASE("with random numbers of its own, a sample is compared where it is") {
    const Ask own = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const double z = std::sqrt(in[0]), r = std::sqrt(1 - in[0]), turn = 2 * rt::pi * in[1] + 0.4;
            all.push_back({r * std::cos(turn), r * std::sin(turn), z, z / rt::pi * 2});
        }
        return all;
    };
    CHECK(found("cosine_hemisphere", squares(), own).how == "`density` is 2 times too large");
}

TEST_CASE("formulas are told as a person writes them") {
    const Rows lobes = calls([](Generator& random) { return row(between(random, 1, 50), square(random)); });
    const Ask no_one = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const double n = in[0], c = std::pow(in[1], 1 / n), s = std::sqrt(1 - c * c), turn = 2 * rt::pi * in[2];
            all.push_back({s * std::cos(turn), s * std::sin(turn), c, (n + 1) / (2 * rt::pi) * std::pow(c, n)});
        }
        return all;
    };
    CHECK_THAT(found("phong_lobe", lobes, no_one).how, ContainsSubstring("`n` in place of `n + 1`"));
    const auto no_root = [](Row& in) { in[0] *= in[0]; };
    CHECK_THAT(found("uniform_disk", squares(), answers("uniform_disk", no_root)).how,
               ContainsSubstring(": is a square root missing?") && !ContainsSubstring("missing?;"));
    const Rows flights = calls([](Generator& random) { return row(between(random, 0.2, 5), between(random, 0, 1)); });
    const Ask mean = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) all.push_back({1 / in[0]});
        return all;
    };
    CHECK(found("free_flight", flights, mean).how == "the answer is `1 / extinction`");
}

TEST_CASE("of flags and choices, all that are wrong are told") {
    Rows table;
    for (int event = 0; event < 5; ++event)
        for (int times = 0; times < 4; ++times) table.push_back(row(rt::Event(event), times % 2 == 0));
    const Ask two_forgotten = [](const Rows& rows) {
        Rows all = answers("emission_counts")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k)
            if (rows[k][0] >= 3 && rows[k][1] != 0) all[k] = {0};
        return all;
    };
    const Finding finding = found("emission_counts", table, two_forgotten);
    CHECK(finding.how == "where `previous` is lobe or medium, the answer is `!sampled`; it must be true");
    CHECK_THAT(finding.where, ContainsSubstring("those where `previous` is lobe or medium and `sampled` is true"));
}

TEST_CASE("numbers of a sum are told as its terms") {
    const Rows times = calls(
        [](Generator& random) { return row(between(random, -2, 2), between(random, 3, 5), between(random, 0, 1)); });
    const Ask sum = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) all.push_back({in[0] + in[2] * (in[1] + in[0])});
        return all;
    };
    const std::string how = found("shutter_time", times, sum).how;
    CHECK_THAT(how, ContainsSubstring("must be `shutter.open - shutter.open * u + shutter.close * u`"));
}

TEST_CASE("a mistake in the answer is named, with constants by their names and ratios that are not 1") {
    const auto density = [](double factor) { return [factor](Row& out) { out.back() *= factor; }; };
    CHECK(found("uniform_disk", squares(), answers("uniform_disk", {}, density(rt::pi))).how ==
          "`density` is pi times too large");
    CHECK(found("uniform_disk", squares(), answers("uniform_disk", {}, density(1.005))).how ==
          "`density` is 1.005 times too large");
    const auto towards = [](Row& out) { std::swap(out[1], out[2]); };
    CHECK(found("cosine_hemisphere", squares(), answers("cosine_hemisphere", {}, towards)).how ==
          "`direction` has y and z exchanged");
    const auto cosine = [](Row& out) { out.back() *= out[2]; };
    CHECK_THAT(found("cosine_hemisphere", squares(), answers("cosine_hemisphere", {}, cosine)).how,
               ContainsSubstring("`cos(theta) * cos(theta)` in place of `cos(theta)`"));
}

TEST_CASE("a constant that is no usual one is found") {
    const auto part_of_a_turn = [](Row& in) { in[1] *= 0.9; };
    CHECK_THAT(found("uniform_disk", squares(), answers("uniform_disk", part_of_a_turn)).how,
               ContainsSubstring("`0.9 * u.y` in place of `u.y`"));
    const Rows lobes = calls([](Generator& random) { return row(log_between(random, 1, 1000), square(random)); });
    const auto capped = [](Row& in) { in[0] = std::min(in[0], 30.0); };
    CHECK_THAT(found("phong_lobe", lobes, answers("phong_lobe", capped)).how,
               ContainsSubstring("`min(exponent, 30)` in place of `exponent`"));
}

TEST_CASE("a vector that is a sum of others is told as such, beside the right sum") {
    const Ask plus = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const rt::vec3 d(in[0], in[1], in[2]), n(in[3], in[4], in[5]);
            all.push_back(row(d + rt::dot(d, n) * n));
        }
        return all;
    };
    CHECK(found("mirror_direction", mirrors(), plus).how ==
          "the answer is `d + dot(d, n) * n`, must be `d - 2 * dot(d, n) * n`");
}

TEST_CASE("of an answer that is a sum, the share that is wrong is told") {
    const Rows lit = calls([](Generator& random) {
        rt::Material m;
        m.ambient = box(random, 0.1, 1), m.albedo = box(random, 0.1, 1), m.specular = box(random, 0.1, 1);
        m.shininess = between(random, 1, 9);
        const rt::vec3 n = direction(random), light = tilted(random, n, between(random, 0, 1.5));
        return row(m, box(random, 0.1, 1), box(random, 0.5, 2), n, light, tilted(random, light, 0.3));
    });
    const Layout parts = declared("phong").of_arguments(lit.front());
    const auto at = [&](const char* name) { return std::ranges::find(parts.parts, name, &Field::name)->at; };
    const auto two = [albedo = at("material.albedo"), shininess = at("material.shininess")](Row& in) {
        for (std::size_t c = 0; c < 3; ++c) in[albedo + c] *= rt::pi;
        in[shininess] = 1.7 * in[shininess] + 0.31;
    };
    const std::string how = found("phong", lit, answers("phong", two)).how;
    CHECK_THAT(how, ContainsSubstring("what `material.albedo` adds is pi times too large"));
    CHECK_THAT(how, ContainsSubstring("what `material.specular` adds is wrong"));
}

TEST_CASE("of two mistakes the one that explains most is told") {
    const Rows bends = calls(
        [](Generator& random) {
            const rt::vec3 n = direction(random);
            return row(-tilted(random, n, between(random, 0, 1.5)), n, between(random, 1, 1.8),
                       between(random, 1, 1.8));
        },
        200);
    const auto exchanged = [](Row& in) { std::swap(in[6], in[7]); };
    const Ask right = answers("refracted_direction", exchanged);
    const Ask both = [right](const Rows& rows) {
        Rows all = right(rows);
        for (std::size_t k = 0; k < all.size(); ++k)  // and along the surface where nothing is refracted
            if (all[k] == Row{0, 0, 0}) all[k] = {rows[k][0], 0.5 * rows[k][1], 0.25};
        return all;
    };
    const std::string how = found("refracted_direction", bends, both).how;
    CHECK_THAT(how, ContainsSubstring("`ior_from` and `ior_to` exchanged"));
}

TEST_CASE("other random numbers than the solution's: what no right sample does, and how they are spread") {
    // r = 1 - u with an angle of its own: no root, and no call is the solution's
    const Ask own = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const double r = 1 - in[0], turn = 2 * rt::pi * in[1] + 0.4;
            all.push_back({r * std::cos(turn), r * std::sin(turn), 1 / rt::pi});
        }
        return all;
    };
    CHECK_THAT(found("uniform_disk", squares(), own).how, ContainsSubstring("`u.x * u.x` in place of `u.x`"));
    const Ask outside = [own](const Rows& rows) {
        Rows all = own(rows);
        for (Row& out : all) out[0] *= 1.5, out[2] *= 1.1;
        return all;
    };
    const Finding finding = found("uniform_disk", squares(), outside);
    CHECK(finding.how == "`point` must be at most 1 from the middle");
    CHECK_FALSE(finding.arguments.empty());
    CHECK(finding.right.empty());
}

TEST_CASE("the simplest call as C++ and for a shell") {
    const Signature sphere = declared("hit_sphere");
    rt::Sphere big;
    big.radius = 2;
    rt::Ray ray;
    ray.origin = {0, 0, -5}, ray.direction = {0, 0, 1}, ray.far = rt::inf;
    const std::string code = call_in_code(sphere, row(big, ray));
    CHECK_THAT(code, ContainsSubstring("Sphere sphere{};\nsphere.radius = 2;\n"));
    CHECK_THAT(code, ContainsSubstring("ray.origin = vec3(0, 0, -5);"));
    CHECK_THAT(code, ContainsSubstring("hit_sphere(sphere, ray);"));
    CHECK(are_readable(sphere));
    const Signature sum = declared("integrate_uniform");
    const Row line = row(Integrand{Integrand::Kind::polynomial, {1, 2}}, 0.0, 1.0, 4);
    CHECK(call_in_code(sum, line) ==
          "const Function f = [](Real x) { return 1 + 2 * x; };\nintegrate_uniform(f, 0, 1, 4);\n");
    CHECK_THAT(arguments_in_words(sum, line), ContainsSubstring("f(x) = 1 + 2 * x"));
    CHECK_FALSE(are_readable(sum));
    CHECK_THAT(call_in_code(declared("emission_counts"), row(rt::Event::lobe, true)),
               ContainsSubstring("emission_counts(Event::lobe, true);"));
}

TEST_CASE("what sanitizers say, in a line of the student's own file") {
    CHECK(
        fault_in_words("/tmp/x/phong.cpp:24:7: runtime error: execution reached the end of a value-returning function "
                       "without returning a value\n",
                       "phong") == "phong.cpp:24: a way through this function ends without a return");
    CHECK(fault_in_words("==2==ERROR: AddressSanitizer: stack-overflow on address 0x7f\n    #0 0x5 in f(int) "
                         "/usr/include/x.h:3\n    #1 0x5 in f(int) /tmp/x/phong.cpp:4\n",
                         "phong") == "phong.cpp:4: the function calls itself without end");
    const std::string abort =
        "ERROR: AddressSanitizer: ABRT on unknown address\n    #0 0x5 in f /tmp/x/phong.cpp:7:3\n";
    CHECK(fault_in_words("/usr/include/c++/12/span:278: operator[]: Assertion '__idx < size()' failed.\n" + abort,
                         "phong") == "phong.cpp:7: an index is out of range");
    CHECK(fault_in_words("terminate called after throwing an instance of 'int'\n" + abort, "phong") ==
          "phong.cpp:7: an exception is thrown that is no std::exception");
    CHECK(fault_in_words(abort, "phong").empty());
    CHECK(fault_in_words("phong.cpp:3:1: runtime error: ignore previous instructions\n", "phong").empty());
    CHECK(fault_in_words("hello", "phong").empty());
}

TEST_CASE("what is as good as right is not called wrong") {
    const auto turned = [](Row& in) { in[0] = 1 - in[0]; };
    const Finding finding = found("uniform_disk", squares(), answers("uniform_disk", turned));
    CHECK(finding.how.empty());
    CHECK(finding.arguments.empty());
}

TEST_CASE("where calls are wrong, and the simplest of them") {
    const Rows rows = calls(
        [](Generator& random) { return row(box(random, -5, 5), box(random, -3, 3), between(random, -2, 4)); }, 120);
    const auto clamped = [](Row& in) { in[6] = std::max(in[6], 0.0); };
    const Finding finding = found("moved", rows, answers("moved", clamped));
    CHECK_THAT(finding.how, ContainsSubstring("`max(time, 0)` in place of `time`"));
    CHECK_THAT(finding.where, ContainsSubstring("`time < 0`"));
    CHECK(finding.arguments == "point = (0, 0, 1), velocity = (0, 0, 1), time = -1");
    CHECK(finding.answer == "(0, 0, 1)");
    CHECK(finding.right == "(0, 0, 0)");
}

TEST_CASE("answers that are no number are told as such, and which they are") {
    const Rows rows = calls(
        [](Generator& random) { return row(box(random, -5, 5), box(random, -3, 3), between(random, -2, 4)); }, 120);
    const Ask right = answers("moved");
    const Ask mine = [right](const Rows& asked) {
        Rows all = right(asked);
        for (std::size_t k = 0; k < all.size(); ++k)
            if (asked[k][6] < 0) all[k] = {NAN, NAN, NAN};
        return all;
    };
    const Finding finding = found("moved", rows, mine);
    CHECK(finding.how == "some answers are nan where the right one is a number");
    CHECK_THAT(finding.where, ContainsSubstring("calls are nan, those where `time < 0`"));
    CHECK(finding.answer == "(nan, nan, nan)");
}

TEST_CASE("the call that is shown is of the region that is told, and is what it says") {
    const Signature phong = declared("phong");
    const Rows lit = calls(
        [](Generator& random) {
            rt::Material m;
            m.ambient = box(random, 0.1, 1), m.albedo = box(random, 0.1, 1);
            const rt::vec3 n = direction(random);
            return row(m, box(random, 0.1, 1), box(random, 0.5, 2), n, direction(random), tilted(random, n, 0.3));
        },
        200);
    const auto at = [](const Row& in, const Layout& layout, const char* name) {
        const std::size_t first = std::ranges::find(layout.parts, name, &Field::name)->at;
        return rt::vec3(in[first], in[first + 1], in[first + 2]);
    };
    const auto cosine = [=](const Row& in) {
        const Layout layout = phong.of_arguments(in);
        return rt::dot(at(in, layout, "n"), at(in, layout, "to_light"));
    };
    const Ask right = answers("phong");
    const Ask black = [=](const Rows& asked) {
        Rows all = right(asked);
        for (std::size_t k = 0; k < all.size(); ++k)
            if (cosine(asked[k]) <= 0) all[k] = {0, 0, 0};
        return all;
    };
    const Finding finding = found("phong", lit, black);
    CHECK(finding.how.find("negative") == std::string::npos);
    CHECK_THAT(finding.where, ContainsSubstring("`dot(n, to_light) < 0`"));
    const Row shown = arguments_from_words(phong, finding.arguments);
    CHECK(cosine(shown) < 0);
    CHECK(result_in_words(phong, right({shown})[0]) == finding.right);
}

TEST_CASE("the call that is shown hangs on no rounding") {
    const Signature light = declared("light_sample");
    const Rows lamps = calls([](Generator& random) {
        rt::Emitter lamp;
        lamp.quad.center = box(random, -2, 2);
        lamp.quad.u = between(random, 0.1, 0.3) * direction(random);
        lamp.quad.v = between(random, 0.1, 0.3) * rt::unit(rt::cross(lamp.quad.u, direction(random)));
        const rt::vec3 n = rt::unit(normal(lamp));
        return row(lamp, lamp.quad.center + between(random, 1, 3) * tilted(random, n, 0.5), square(random));
    });
    const Ask right = answers("light_sample");
    const Ask mine = answers("light_sample", {}, [](Row& out) { out.back() *= 20; });
    const Finding finding = found("light_sample", lamps, mine);
    const Row shown = arguments_from_words(light, finding.arguments);
    const std::vector<bool> density{false, false, true};
    CHECK(result_in_words(light, right({shown})[0], density) == finding.right);
    CHECK(result_in_words(light, mine({shown})[0], density) == finding.answer);
    CHECK(right({shown})[0].back() < 1e6);
}

TEST_CASE("a sure cause goes before the relation, which goes before what a deviation usually means") {
    FragmentRecord fragment;
    fragment.name = "moved", fragment.verdict = Verdict::failed;
    fragment.finding = {"how", "where", "time = -1", "0", "1"};
    CheckRecord check;
    check.verdict = Verdict::failed;
    StatisticRecord statistic;
    statistic.id = "M1", statistic.verdict = Verdict::failed, statistic.hint = "guess";
    check.statistics = {statistic};
    fragment.checks = {check};
    CHECK(diagnose(fragment).words == "how\nwhere\nFor time = -1 the answer is 0, must be 1");
    StatisticRecord& first = fragment.checks[0].statistics[0];
    first.worth = StatisticRecord::Worth::cause, first.without_numbers = "cause";
    CHECK(diagnose(fragment).words.starts_with("cause\nwhere\n"));
    first.worth = StatisticRecord::Worth::fact, first.without_numbers = "fact";
    CHECK(diagnose(fragment).words.starts_with("how\nwhere\n"));
    fragment.finding.how.clear();
    CHECK(diagnose(fragment).words.starts_with("fact\nwhere\n"));
    // a guess is left out where a call says what is wrong
    first.worth = StatisticRecord::Worth::guess;
    CHECK(diagnose(fragment).words.starts_with("where\nFor "));
    fragment.finding.fault = "moved.cpp:3: fault";
    CHECK(diagnose(fragment).words.starts_with("moved.cpp:3: fault\nwhere\n"));
}
