#include <cmath>
#include <random>

#include "catch.h"
#include "convergence/record.h"
#include "convergence/report.h"

using namespace grade;
using namespace grade::convergence;

namespace {

using Engine = std::mt19937_64;

/// MSE = b^2 + v N^(-2q) on levels 1 ... 1024, each of some replicates that scatter by a share of it.
std::vector<LevelErrors> curve(double b, double v, double q, double scatter, int replicates, Engine& random) {
    std::normal_distribution<double> normal;
    std::vector<LevelErrors> levels;
    for (double n = 1; n <= 1024; n *= 4) {
        levels.push_back({n, {}});
        for (int k = 0; k < replicates; ++k)
            levels.back().mse.push_back((b * b + v * std::pow(n, -2 * q)) * (1 + scatter * normal(random)));
    }
    return levels;
}

/// A picture of noise about a brightness that differs from pixel to pixel.
rt::Image noisy(double bias, double deviation, Engine& random) {
    std::normal_distribution<double> normal;
    rt::Image image(48, 48);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        for (int c = 0; c < 3; ++c) image.pixels[i][c] = 1 + std::sin(double(i)) + bias + deviation * normal(random);
    return image;
}

}  // namespace

TEST_CASE("the fit finds slope, factor and plateau of curves without noise") {
    Engine random(1);
    for (const double q : {0.5, 0.75, 1.0}) {
        INFO("q = " << q);
        const Fit straight = fit_errors(curve(0, 0.3, q, 0, 1, random), Estimate{0, 1e-6});
        CHECK(straight.order == Approx(-q).epsilon(1e-6));
        CHECK(straight.v == Approx(0.3).epsilon(1e-6));
        CHECK(straight.plateau == 0);
        const Fit bent = fit_errors(curve(0.02, 0.3, q, 0, 1, random), std::nullopt);
        CHECK(bent.order == Approx(-q).epsilon(1e-4));
        CHECK(std::sqrt(bent.plateau) == Approx(0.02).epsilon(1e-4));
        CHECK(bent.v == Approx(0.3).epsilon(1e-4));
    }
}

TEST_CASE("the fit's 95 % interval holds the slope in 95 of 100 cases") {
    Engine random(2);
    for (const double b : {0.0, 0.03}) {
        int held = 0, runs = 400;
        for (int run = 0; run < runs; ++run) {
            const double se = 1e-5;
            const Estimate bias{b * b + se * std::normal_distribution<double>()(random), se};
            const Fit fit = fit_errors(curve(b, 0.5, 0.6, 0.05, 4, random), bias);
            held += fit.low <= -0.6 && -0.6 <= fit.high;
        }
        INFO("b = " << b << ": " << held << " of " << runs);
        CHECK(held > 0.92 * runs);  // 4 standard errors
        CHECK(held < runs);
    }
}

TEST_CASE("a curve that is no power law gets an interval that says so") {
    Engine random(3);
    auto levels = curve(0, 1, 0.5, 0.01, 8, random);
    for (auto& level : levels)
        for (double& mse : level.mse) mse *= 1 + 0.5 * std::sin(std::log(level.samples));
    const Fit fit = fit_errors(levels, Estimate{0, 1e-9});
    CHECK(fit.high - fit.low > 0.1);
    CHECK(fit.low < -0.5);
    CHECK(fit.high > -0.5);
}

TEST_CASE("too few levels have no slope, and no error has none") {
    Engine random(4);
    auto levels = curve(0, 1, 0.5, 0.1, 4, random);
    levels.resize(2);
    CHECK_FALSE(fit_errors(levels, std::nullopt).good);
    for (auto& level : levels) level.mse = {0, 0, 0};
    CHECK_FALSE(fit_errors(levels, std::nullopt).good);
    CHECK_FALSE(fit_errors({}, std::nullopt).good);
}

TEST_CASE("two halves of a reference give the error without bias, however noisy they are") {
    Engine random(5);
    double sum = 0;
    const int runs = 60;
    for (int run = 0; run < runs; ++run) {
        const Halves halves{noisy(0, 0.2, random), noisy(0, 0.2, random)};
        sum += squared_error(noisy(0, 0.1, random), halves).mse / runs;
    }
    // one half alone would give 0.05, both as one picture 0.03; the noise of this mean is 0.0001
    CHECK(sum == Approx(0.01).margin(0.0004));
    const Halves exact{noisy(0, 0, random), noisy(0, 0, random)};
    const SquaredError error = squared_error(noisy(0.1, 0, random), exact);
    CHECK(error.mse == Approx(0.01).epsilon(1e-9));
    double relative = 0;
    for (const rt::Color& r : exact.first.pixels)
        relative += 0.01 / (r.x * r.x + 0.01) / double(exact.first.pixels.size());
    CHECK(error.relative == Approx(relative).epsilon(1e-9));
    CHECK(noise_of({noisy(0, 0.2, random), noisy(0, 0.2, random)}) == Approx(0.2 / std::sqrt(2)).epsilon(0.05));
}

TEST_CASE("a bias is found where there is one, and its standard error is right where there is none") {
    Engine random(6);
    double squares = 0;
    const int runs = 200;
    for (int run = 0; run < runs; ++run) {
        const Halves halves{noisy(0, 0.02, random), noisy(0, 0.02, random)};
        const Estimate none = picture_bias(noisy(0, 0.05, random), noisy(0, 0.05, random), halves);
        CHECK_FALSE(none.is_positive());
        squares += std::pow(none.value / none.se, 2) / runs;
    }
    // the channels of these pictures do not share their noise: the standard error is 1.7 times too large
    CHECK(squares == Approx(1.0 / 3).margin(0.12));

    const Halves halves{noisy(0, 0.02, random), noisy(0, 0.02, random)};
    const Estimate bias = picture_bias(noisy(0.02, 0.05, random), noisy(0.02, 0.05, random), halves);
    CHECK(bias.is_positive());
    CHECK(std::sqrt(bias.value) == Approx(0.02).margin(0.004));
    // in one pixel of 2304
    rt::Image one = noisy(0, 0.01, random), other = noisy(0, 0.01, random);
    one.pixels[777] += 0.5, other.pixels[777] += 0.5;
    CHECK(picture_bias(one, other, halves).is_positive());
}

TEST_CASE("times and errors between the levels lie on straight lines on logarithmic axes") {
    std::vector<Waypoint> path;
    for (double n = 1; n <= 256; n *= 4) path.push_back({n, 0.001 * n, 1 / n});
    CHECK(mse_at(path, 0.001 * 32).value() == Approx(1.0 / 32));
    CHECK(seconds_for(path, 1.0 / 100).value() == Approx(0.1));
    // a little beyond the levels, but not far
    CHECK(seconds_for(path, 1.0 / 1000).value() == Approx(1.0));
    CHECK_FALSE(seconds_for(path, 1e-4).has_value());
    CHECK_FALSE(mse_at(path, 10).has_value());
    // a plateau is never passed
    for (Waypoint& place : path) place.mse += 0.1;
    CHECK_FALSE(seconds_for(path, 0.05).has_value());
    CHECK_FALSE(seconds_for(path, 0.0).has_value());
    // a level that is slower than the next one, by noise
    std::vector<Waypoint> noisy_path{{1, 0.002, 1}, {4, 0.001, 0.25}, {16, 0.016, 0.06}};
    CHECK(mse_at(noisy_path, 0.008).value() < 1);
}

TEST_CASE("a submission that needs three times the time and twice the samples has these ratios") {
    Engine random(7);
    std::normal_distribution<double> normal;
    SceneRecord scene;
    scene.name = "made_up";
    for (const bool solution : {false, true}) {
        Curve curve{solution ? Who::solution : Who::submission, "random", {}, Estimate{0, 1e-12}, {}};
        for (int n = 1; n <= 1024; n *= 4) {
            curve.levels.push_back({n, {}});
            for (int k = 0; k < 8; ++k) {
                const double error = (solution ? 1.0 : 2.0) / n * (1 + 0.02 * normal(random));
                const double seconds = 1e-3 * n * (solution ? 1 : 3) * (1 + 0.02 * normal(random));
                curve.levels.back().runs.push_back({error, error, seconds, double(n)});
            }
        }
        scene.curves.push_back(curve);
    }
    analyse(scene);
    REQUIRE(scene.comparisons.size() == 1);
    const Comparison& c = scene.comparisons[0];
    CHECK(scene.errors[0].value() == Approx(1.0 / 64).epsilon(0.03));
    for (const auto& ratio : {c.mse_at_equal_time, c.time_at_error[0]}) {
        REQUIRE(ratio.has_value());
        CHECK(ratio->value == Approx(6).epsilon(0.06));
        CHECK(ratio->low < 6.2);
        CHECK(ratio->high > 5.8);
        CHECK(ratio->high / ratio->low < 1.2);
    }
    CHECK(scene.curves[1].seconds_for(1.0 / 64)->value == Approx(0.064).epsilon(0.05));
    CHECK(scene.find(Who::solution, "random")->levels.back().efficiency() == Approx(1 / (1e-3)).epsilon(0.06));
    CHECK(scene.biased() == nullptr);
    scene.curves[0].bias = Estimate{1e-4, 1e-6};
    REQUIRE(scene.biased() != nullptr);

    ConvergenceRecord record;
    record.scenes = {scene};
    CHECK(table(record, false).find("plateau of 0.01 (") != std::string::npos);
    CHECK(report(record).find("made_up-seconds.svg") != std::string::npos);
    CHECK(to_csv(record).find("made_up,solution,random,1024,8,") != std::string::npos);
    CHECK(to_json(record).find("\"biased\": true") != std::string::npos);
    const std::string svg = log_log(error_plot(scene, Against::seconds));
    for (const char* piece : {"-1/2", "-3/4", "random, right", "<polygon", "stroke-dasharray"}) {
        INFO(piece);
        CHECK(svg.find(piece) != std::string::npos);
    }
}
