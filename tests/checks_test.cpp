#include <map>
#include <set>

#include "assignment/assignment.h"
#include "catch.h"
#include "checks/kit/check.h"
#include "checks/kit/estimate.h"
#include "checks/kit/later.h"
#include "checks/kit/render_check.h"
#include "judging/experiment.h"
#include "rt/files/scene_reader.h"
#include "rt/plan.h"
#include "rt/render.h"

using namespace grade;

TEST_CASE("random points that reach the ends of the square have the mean of uniform ones") {
    Generator random(7);
    constexpr int count = 200'000;
    rt::vec2 sum(0);
    int at_low_end = 0, at_high_end = 0;
    for (int k = 0; k < count; ++k) {
        const rt::vec2 u = square_with_ends(random);
        sum += u, at_low_end += u.x == 0, at_high_end += u.x == 1 - 0x1p-53;
    }
    constexpr double five_deviations = 5 * 0.31 / 447;
    CHECK(std::abs(sum.x / count - 0.5) < five_deviations);
    CHECK(std::abs(sum.y / count - 0.5) < five_deviations);
    CHECK(at_low_end > count / 200);
    CHECK(at_high_end > count / 200);
}

TEST_CASE("every fragment of the assignment has checks, in its order, and no other has") {
    std::vector<std::string> checked;
    for (const Check& check : all_checks(1))
        if (checked.empty() || checked.back() != check.fragment) checked.push_back(check.fragment);
    CHECK(checked == read_assignment("assignment.toml").names());
}

TEST_CASE("a check's name is its own within the fragment") {
    std::set<std::string> names;
    for (const Check& check : all_checks(2)) {
        CAPTURE(check.fragment, check.name);
        CHECK(names.insert(check.fragment + "/" + check.name).second);
        CHECK(!check.statistics.empty());
        for (const Statistic& statistic : check.statistics) {
            CHECK((statistic.hint || statistic.cause));
            if (!statistic.exact) CHECK(statistic.delta > statistic.delta0);
        }
    }
}

TEST_CASE("the scenes of ten grading seeds can be read, and another seed draws other scenes") {
    std::map<std::string, std::set<std::string>> scenes;
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        for (const Check& check : all_checks(seed))
            if (const auto* render = std::get_if<Render>(&check.experiment)) {
                CAPTURE(seed, check.fragment, check.name);
                CHECK_NOTHROW(rt::parse_scene(render->scene, check.name));
                scenes[check.fragment + "/" + check.name].insert(render->scene);
            }
    for (const auto& [name, drawn] : scenes) {
        CAPTURE(name);
        CHECK(drawn.size() == 10);
    }
}

TEST_CASE("pictures of checks find lamps as fragments do: by light_sample or by rays alone; no path ends early") {
    for (std::uint64_t seed = 1; seed <= 10; ++seed)
        for (const Check& check : all_checks(seed))
            if (const auto* render = std::get_if<Render>(&check.experiment)) {
                CAPTURE(seed, check.fragment, check.name);
                const rt::RenderPlan plan = rt::make_plan(rt::parse_scene(render->scene, check.name));
                CHECK(!plan.solid_angle);
                CHECK(!plan.one_lamp);
                CHECK(!plan.weigh);
                CHECK(!plan.media_lit);
                CHECK(!plan.roulette);
            }
}

TEST_CASE("a scene of a file has a value in place of each name in braces, and tables in braces stay") {
    const SceneKeys values = {{"at", rt::vec3(1, 2.5, 0)}, {"n_1", 3}};
    CHECK(filled_in("a = {at}\nb = [{n_1}, {n_1}] # {at}\nm = { g = 0.5 }\ne = {}", "f.toml", values) ==
          "a = [1, 2.5, 0]\nb = [3, 3] # [1, 2.5, 0]\nm = { g = 0.5 }\ne = {}");
    const auto complaint = [&](const std::string& text, const SceneKeys& given) {
        return complaint_of([&] { filled_in(text, "f.toml", given); });
    };
    CHECK(complaint("a = {at}\nb = {n_2}", values) ==
          "f.toml:2:5: the check gives no value for {n_2}; expected {n_1}?");
    CHECK(complaint("{other}", {}) ==
          "f.toml:1:1: the check gives no value for {other}; expected {\"other\", ...} in its scene_from");
    CHECK(complaint("a = {at}\nbc", values) ==
          "f.toml:2:3: the check gives a value for n_1, which stands nowhere; expected {n_1} in this file");
    CHECK(complaint_of([] { scene_from("hollow_spere.toml", {}); }) ==
          "grader/checks/hollow_spere.toml:1:1: there is no such file; expected hollow_sphere.toml?");
    // what is no scene is told where it stands in the file
    const auto hollow = [](const SceneValue& radius) {
        return complaint_of([&] {
            scene_from("hollow_sphere.toml", {{"bounces", 3},
                                              {"eye", rt::vec3(0)},
                                              {"target", rt::vec3(0, 0, -1)},
                                              {"up", rt::vec3(0, 1, 0)},
                                              {"albedo", 0.5},
                                              {"center", rt::vec3(0)},
                                              {"intensity", 1},
                                              {"radius", radius}});
        });
    };
    CHECK(hollow(1) == "");
    CHECK(hollow(-1).starts_with("grader/checks/hollow_sphere.toml:24:"));
}

TEST_CASE("one seed gives one set of checks") {
    const auto a = all_checks(7), b = all_checks(7);
    REQUIRE(a.size() == b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (const auto* render = std::get_if<Render>(&a[k].experiment))
            CHECK(render->scene == std::get<Render>(b[k].experiment).scene);
        for (std::size_t i = 0; i < a[k].statistics.size(); ++i)
            CHECK(a[k].statistics[i].truth == b[k].statistics[i].truth);
    }
}

namespace {

/// Probes whose arguments are too few to differ, each with its reason.
const std::map<std::string, std::string> same_arguments = {
    {"emission_counts/truth_table", "an event and a bool: all ten combinations are asked"},
};

/// Pictures of the solution that pass under other seeds as well, each with its reason.
const std::map<std::string, std::string> same_pictures = {
    {"film_sample/fine_stripes", "any noise is right that pixels do not share"},
    {"shutter_time/passing_train", "any noise is right that pixels do not share, and as large"},
    {"lens_ray/two_colors",
     "the colours of any spot are right that do not go with the place; depths and corner look at the spot itself"},
};

}  // namespace

TEST_CASE("another seed draws other arguments for every probe, so remembered answers do not pass") {
    const auto first = all_checks(1), second = all_checks(2);
    REQUIRE(first.size() == second.size());
    for (std::size_t k = 0; k < first.size(); ++k) {
        const auto* probe = std::get_if<Probe>(&first[k].experiment);
        if (!probe) continue;
        const std::string name = first[k].fragment + "/" + first[k].name;
        CAPTURE(name);
        const auto rows = [](const Check& check, std::uint64_t seed) {
            Generator random(replicate_seed(seed, check, Stream::submission, 0));
            return std::get<Probe>(check.experiment).inputs(random);
        };
        const Rows one = rows(first[k], 1), other = rows(second[k], 2);
        const std::set<Row> known(one.begin(), one.end());
        const double seen = double(std::ranges::count_if(other, [&](const Row& row) { return known.contains(row); }));
        if (same_arguments.contains(name))
            CHECK(seen > 0);
        else
            CHECK(seen <= 0.05 * double(other.size()));
    }
}

TEST_CASE("a picture that the solution draws under one seed does not pass under others") {
    const auto first = all_checks(1);
    std::vector<std::vector<Check>> others;
    for (std::uint64_t seed = 2; seed <= 5; ++seed) others.push_back(all_checks(seed));
    for (std::size_t k = 0; k < first.size(); ++k) {
        const auto* render = std::get_if<Render>(&first[k].experiment);
        if (!render) continue;
        const std::string name = first[k].fragment + "/" + first[k].name;
        CAPTURE(name);
        const rt::RenderSettings settings{.samples = render->samples,
                                          .threads = 1,
                                          .sampler = *rt::sampler_named(render->sampler),
                                          .one_of_many = true,
                                          .estimate_error = false};
        Observation copied;
        copied.image = rt::render(rt::parse_scene(render->scene, "scenes/scene.toml"), settings).image;
        const auto is_off = [&](const Statistic& s) {
            return !s.truth || !(std::abs(measured(s, copied) - *s.truth) <= 1.5 * s.delta);
        };
        const auto fails = std::ranges::count_if(
            others, [&](const auto& checks) { return std::ranges::any_of(checks[k].statistics, is_off); });
        // parameters may be close to each other by chance
        if (same_pictures.contains(name))
            CHECK(fails == 0);
        else
            CHECK(fails >= 1);
    }
}

TEST_CASE("what takes a while is made once, when it is first asked for") {
    int made = 0;
    const auto number = later([&] { return ++made; });
    const auto copy = number;
    CHECK(made == 0);
    CHECK(number() == 1);
    CHECK(copy() == 1);
    CHECK(made == 1);
}
