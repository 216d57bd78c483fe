#include <array>

#include "explained.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

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
    CHECK_THAT(found("light_sample", lamps(), both_sides).how, ContainsSubstring("abs(cosine) at the lamp"));
}

TEST_CASE("of a lamp of one kind, the others' fields are not told") {
    const Ask no_cosine = with_density([](const rt::Emitter& lamp, double cosine, double squared) {
        return cosine > 0 ? squared / (lamp.kind == rt::Emitter::Kind::quad ? 1 : cosine) : 0;
    });
    const std::string how = found("light_sample", lamps(), no_cosine).how;
    CHECK_THAT(how, ContainsSubstring("where `light.kind` is quad, ") &&
                        ContainsSubstring("`area(light)` in place of `cosine * area(light)`"));
    CHECK(how.find("disc") == how.npos);
    const Ask whole_edges = [](const Rows& rows) {
        Rows moved = rows;
        for (Row& in : moved)
            if (in[0] == 0)
                for (const std::size_t at : {in.size() - 2, in.size() - 1}) in[at] = (1 + in[at]) / 2;
        return answers("light_sample")(moved);
    };
    const Finding quarter = found("light_sample", lamps(), whole_edges);
    CHECK_THAT(quarter.how, ContainsSubstring("numbers from 0 to 1 before the half edges of a quad, a quarter of it"));
    CHECK_THAT(quarter.where, ContainsSubstring("`light.kind` is quad"));
    CHECK(quarter.how.find("disc") == quarter.how.npos);
}

TEST_CASE("what is wrong with each vector of a shape alike is told of the first, and the others are named") {
    // a quad with half of both edges, as in the example
    const Ask half_edges = answers("light_sample", [](Row& in) {
        RowReader reader(in);
        auto lamp = read(reader, Tag<rt::Emitter>{});
        lamp.quad.u *= 0.5, lamp.quad.v *= 0.5;
        const Row changed = row(lamp);
        std::ranges::copy(changed, in.begin());
    });
    CHECK_THAT(found("light_sample", lamps(), half_edges).how,
               ContainsSubstring("as if it had `light.quad.u / 2` in place of `light.quad.u`, and the same for "
                                 "`light.quad.v`"));
    const Ask mirrored = answers("hit_triangle", [](Row& in) {
        for (std::size_t at = 0; at < 9; ++at) in[at] *= -1;
    });
    const Rows aimed = calls([](Generator& random) {
        const rt::vec3 a = box(random, -2, 2), b = box(random, -2, 2), c = box(random, -2, 2);
        const rt::vec3 from = box(random, -4, 4), at = (chance(random, 0.5) ? 1.0 : -1.0) * (a + b + c) / 3.0;
        return row(rt::Triangle{a, b, c}, rt::Ray{from, at - from, 0, rt::inf});
    });
    CHECK_THAT(found("hit_triangle", aimed, mirrored).how,
               ContainsSubstring("`-triangle.a` in place of `triangle.a`, and the same for `triangle.b` and "
                                 "`triangle.c`"));
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
    CHECK_THAT(how, ContainsSubstring("columns of one width"));
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
          "the fragment answers exactly as if it had `-g` in place of `g`");
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
    CHECK_THAT(found("phong_lobe", lobes, no_one).how, ContainsSubstring("`exponent` in place of `exponent + 1`"));
    const auto no_root = [](Row& in) { in[0] *= in[0]; };
    CHECK_THAT(
        found("uniform_disk", squares(), answers("uniform_disk", no_root)).how,
        ContainsSubstring(": is a square root missing, or does it count twice?") && !ContainsSubstring("twice?;"));
    const Rows flights = calls([](Generator& random) { return row(between(random, 0.2, 5), between(random, 0, 1)); });
    const Ask mean = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) all.push_back({1 / in[0]});
        return all;
    };
    CHECK(found("free_flight", flights, mean).how ==
          "the fragment answers exactly as if it had `1 / extinction` in place of `-log(1 - u) / extinction`");
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
               ContainsSubstring("`cosine * cosine` in place of `cosine`, where a textbook has `cosine / pi`"));
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
