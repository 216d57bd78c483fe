#include <regex>

#include "explained.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

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
    CHECK(finding.says_which);
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
