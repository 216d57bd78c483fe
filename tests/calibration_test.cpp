#include <cmath>
#include <random>
#include <utility>

#include "calibration/nominal.h"
#include "calibration/peers.h"
#include "calibration/pool.h"
#include "calibration/real.h"
#include "calibration/replay.h"
#include "calibration/report.h"
#include "calibration/summary.h"
#include "calibration/variant.h"
#include "calibration/workshop.h"
#include "catch.h"
#include "files/files.h"
#include "report/plot.h"

using namespace grade;
using namespace grade::calibration;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A check with one statistic that must be 1 within 0.1.
Check one_check() {
    Check check;
    check.name = "one", check.fragment = "phong";
    check.statistics = {{.id = "L1",
                         .what = "number",
                         .measure = [](const Observation&) { return 0.0; },
                         .truth = 1,
                         .delta0 = 0.01,
                         .delta = 0.1}};
    return check;
}

Pool pool_of(int replicates, const std::function<double(std::mt19937_64&)>& draw) {
    std::mt19937_64 random(5);
    Pool pool;
    pool.statistics = 1;
    for (int k = 0; k < replicates; ++k) pool.scalars.push_back(draw(random));
    pool.cpu_seconds = replicates * 0.5;
    return pool;
}

Pool normal(double mean, double deviation) {
    return pool_of(4096, [=](auto& random) { return std::normal_distribution<double>(mean, deviation)(random); });
}

Tally replayed(const Pool& pool, long gradings) {
    const Check check = one_check();
    Settings settings;
    settings.statistics = 100;
    return replay({{{&check, &pool}}}, settings, gradings, 1);
}

Variant variant_of(const std::string& name, const std::string& fragment) {
    Variant variant;
    variant.name = name, variant.fragment = fragment;
    return variant;
}

}  // namespace

TEST_CASE("every patch of the variants says what it is, and applies") {
    const auto variants = read_variants("tests/variants");
    CHECK(variants.size() > 200);
    for (const Variant& variant : variants) {
        INFO(variant.name);
        CHECK(!variant.what.empty());
        CHECK((variant.kind == Variant::Kind::dose) == !variant.doses.empty());
        CHECK((variant.kind == Variant::Kind::confined) == !variant.scene.empty());
        const std::string text = changed_text(variant, ".", variant.doses.empty() ? "" : variant.doses.front());
        CHECK(text != read_text("solution/" + variant.fragment + ".cpp"));
        CHECK(text.find("DOSE") == text.npos);
    }
}

TEST_CASE("a patch without a fragment, or with an unknown key, is named with its line") {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "wrong");
    write_text(folder.path() / "wrong/1_a.patch", "# 1 a\n# fragmnt: phong\n");
    CHECK_THROWS_WITH(read_variants(folder.path()), ContainsSubstring("1_a.patch:2:3: unknown key fragmnt"));
    write_text(folder.path() / "wrong/1_a.patch", "# 1 a\n--- x\n");
    CHECK_THROWS_WITH(read_variants(folder.path()), ContainsSubstring("1_a.patch:2:1: no fragment is named"));
    Variant stale = variant_of("wrong/stale", "phong");
    stale.patch =
        "# x\n# fragment: phong\n--- a/solution/phong.cpp\n+++ b/solution/phong.cpp\n@@ -1,2 +1,2 @@\n"
        "-nothing of the kind\n+else\n x\n";
    CHECK_THROWS_WITH(changed_text(stale, "."),
                      ContainsSubstring("wrong/stale.patch:1:1: does not apply to solution/phong.cpp any more"));
}

TEST_CASE("bundles hold each variant once, and no fragment twice") {
    const std::vector<Variant> all{variant_of("a", "phong"), variant_of("b", "phong"), variant_of("c", "moved"),
                                   variant_of("d", "whitted")};
    std::vector<const Variant*> list;
    for (const Variant& variant : all) list.push_back(&variant);
    for (const bool alternate : {false, true}) {
        std::multiset<std::string> names;
        for (const Bundle& bundle : bundles(list, "x", alternate)) {
            std::set<std::string> fragments;
            for (const Variant* variant : bundle.variants) {
                names.insert(variant->name);
                CHECK(fragments.insert(variant->fragment).second);
            }
        }
        CHECK(names == std::multiset<std::string>{"a", "b", "c", "d"});
    }
}

TEST_CASE("a store comes back as it was written; half a file is none") {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "deep/pool";
    Pool pool = normal(1, 0.1);
    pool.faults = 2, pool.ignores_seed = true;
    write_pool(file, pool);
    const auto back = read_pool(file);
    REQUIRE(back);
    CHECK(back->scalars == pool.scalars);
    CHECK(back->faults == 2);
    CHECK(back->ignores_seed);
    CHECK_FALSE(back->unfit);
    CHECK(back->seconds_per_replicate() == Approx(0.5));
    const std::string text = read_text(file).value();
    write_text(file, text.substr(0, text.size() / 2));
    CHECK_FALSE(read_pool(file));
    CHECK_FALSE(read_pool(folder.path() / "missing"));
}

TEST_CASE("a store is filled up: what is there stays, and what is added is as if all were made at once") {
    const TemporaryFolder folder;
    const Workshop workshop(GRADE_TOOLCHAIN, folder.path(), {}, {"uniform_disk"});
    const fs::path program = workshop.solution_program();
    const auto collected = [&](int replicates, const Pool& before) {
        return collect(*workshop.checks(1, "uniform_disk").front(), 1, replicates, program, program, workshop.sandbox(),
                       workshop.meshes(), before);
    };
    const Pool all = collected(5, {});
    Pool some = collected(2, {});
    CHECK((some.has(2) && !some.has(5) && all.has(5)));
    const double first = std::exchange(some.scalars.at(0), -7);
    some.cpu_seconds = 100;
    Pool filled = collected(5, some);
    CHECK(std::exchange(filled.scalars.at(0), first) == -7);
    CHECK(filled.scalars == all.scalars);
    CHECK(filled.cpu_seconds >= 100);
    // a program that breaks down gives no more
    some.faults = most_faults;
    CHECK((some.has(5) && collected(5, some).replicates() == 2));
}

TEST_CASE("replays pass what is right, fail what is off, and cost what their replicates cost") {
    const Tally right = replayed(normal(1, 0.05), 20000);
    CHECK(right.passed == 20000);
    CHECK(right.cpu_seconds == Approx(0.5 * right.replicates));
    CHECK(right.replicates >= 8 * 20000);

    CHECK(replayed(normal(1.2, 0.05), 2000).failed == 2000);
    CHECK(replayed(pool_of(64, [](auto&) { return std::nan(""); }), 10).failed == 10);

    // between delta0 and delta nothing is certain, and it is not called a failure often
    const Tally between = replayed(normal(1.1, 1), 2000);
    CHECK(between.inconclusive > 1900);

    Pool unfit = normal(1, 0.05);
    unfit.unfit = true;
    CHECK(replayed(unfit, 10).failed == 10);
}

TEST_CASE("a fixed number of replicates is enough or is not, and costs the same either way") {
    const Check check = one_check();
    const auto fixed = [&](const Pool& pool, int replicates) {
        return replay_fixed({{{&check, &pool}}}, Settings{}, replicates, 2000, 1);
    };
    CHECK(fixed(normal(1, 0.05), 64).passed == 2000);
    CHECK(fixed(normal(1.2, 0.05), 64).failed == 2000);
    CHECK(fixed(normal(1, 0.05), 3).inconclusive > 1900);
    CHECK(fixed(normal(1.2, 0.05), 3).inconclusive > 1900);
    CHECK(fixed(normal(1, 0.05), 64).cpu_seconds == Approx(2000 * 0.5 * 65));
    CHECK(fixed(pool_of(64, [](auto&) { return std::nan(""); }), 8).failed == 2000);
}

TEST_CASE("a normal statistic rejects as often as promised; one that is mostly constant does not") {
    const Check check = one_check();
    const Pool good = normal(1, 0.05);
    const Pool spikes = pool_of(
        4096, [](auto& random) { return std::uniform_real_distribution<double>()(random) < 0.01 ? 10.0 : 0.9; });
    const auto rate = [&](const Pool& pool) { return nominal_rates({{&check, &pool}}, 100'000, 3).at(0); };
    CHECK(rate(good).at_2 == Approx(1).margin(0.15));
    CHECK(rate(good).at_3 == Approx(1).margin(0.4));
    CHECK(rate(good).bias < 0.05);
    CHECK((rate(spikes).at_2 > 2 || rate(spikes).at_2 < 0.5));
    // the solution's own deviation from the truth is seen
    CHECK(rate(normal(1.05, 0.05)).tilt > 4);
}

TEST_CASE("the rules of others: a mean that is off is found, a few wrong pixels are not") {
    std::mt19937_64 random(2);
    std::normal_distribution<double> noise(1, 0.05);
    const auto picture = [&] {
        rt::Image image(64, 64);
        for (rt::Color& pixel : image.pixels) pixel = rt::Color(noise(random), noise(random), noise(random));
        return image;
    };
    const auto mean = [&](int count) {
        PixelMoments moments;
        for (int k = 0; k < count; ++k) moments.add(picture());
        return moments;
    };
    const PixelMoments reference = mean(256);
    CHECK(rt::largest(reference.variance(7)) == Approx(0.0025).epsilon(0.5));

    const rt::Image right = mean(16).mean;
    const PeerRules same = judged_by_peers(right, 16, reference);
    CHECK((same.z_test && same.mean_difference && same.global_mean));

    rt::Image brighter = right, spoiled = right;
    for (rt::Color& pixel : brighter.pixels) pixel *= 1.05;
    CHECK_FALSE(judged_by_peers(brighter, 16, reference).global_mean);
    for (int k = 0; k < 8; ++k) spoiled.pixels[std::size_t(k)] = rt::Color(0);
    const PeerRules few = judged_by_peers(spoiled, 16, reference);
    CHECK((few.z_test && few.mean_difference && few.global_mean));
}

TEST_CASE("bounds of rates: none in 300 is below 1 %, and half is about a half") {
    CHECK(rate_bounds(0, 300).second == Approx(1 - std::pow(0.05, 1.0 / 300)));
    CHECK(rate_bounds(0, 300).first == 0);
    const auto [low, high] = rate_bounds(50, 100);
    CHECK(low == Approx(0.398).margin(0.002));
    CHECK(high == Approx(0.602).margin(0.002));
}

TEST_CASE("steps of all shards together are all steps; what is done is not done again") {
    const TemporaryFolder folder;
    std::vector<calibration::Step> steps;
    std::vector<int> runs(7);
    for (int i = 0; i < 7; ++i) {
        const fs::path file = folder.path() / std::to_string(i);
        steps.push_back({"step", {file}, [file, i, &runs] { ++runs[std::size_t(i)], write_text(file, "done"); }});
    }
    for (int turn = 0; turn < 2; ++turn)
        for (int shard = 0; shard < 3; ++shard) run_steps(steps, shard, 3, 1, {});
    CHECK(runs == std::vector<int>(7, 1));
}

TEST_CASE("of what was not measured the report says so once") {
    Summary summary;
    summary.steps = 121;
    const std::string nothing = calibration_report(summary, "grade calibrate --report", "plot.svg");
    CHECK(nothing.find("none of 121 steps is done") != std::string::npos);
    CHECK(nothing.find("ot run") == std::string::npos);
    CHECK(nothing.find("alpha") == std::string::npos);
    CHECK(nothing.find("* neighbours spoiled, real gradings: 0\n") != std::string::npos);

    summary.steps_done = 1, summary.neighbours = 7;
    const std::string some = calibration_report(summary, "grade calibrate --report", "plot.svg");
    CHECK(some.find("| neighbours spoiled, real gradings | 0 | 0 of 7 (0.0 %) |") != std::string::npos);
    CHECK(some.find("* same submission and seed") != std::string::npos);
    CHECK(some.find("**Alpha** is the rate") != std::string::npos);
}

TEST_CASE("a plot shows each series by name, and leaves out what a logarithm cannot show") {
    const std::string svg =
        log_log({"a < b", "time [s]", "error", {{"mine & yours", {{1, 0.1}, {10, 0}, {100, 0.001}}}}});
    CHECK(svg.find("a &lt; b") != svg.npos);
    CHECK(svg.find("mine &amp; yours") != svg.npos);
    CHECK(svg.find("nan") == svg.npos);
    CHECK(svg.find("inf") == svg.npos);
    std::size_t dots = 0;
    for (std::size_t at = 0; (at = svg.find("<circle", at)) != svg.npos; ++at) ++dots;
    CHECK(dots == 2);
}
