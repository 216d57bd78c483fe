#include <random>

#include "catch.h"
#include "statistics/engine.h"

using namespace grade;

namespace {

/// Feeds replicates until the judge decides.
template <class Draw>
Judgement decide(Tolerance tolerance, Settings settings, double truth, Draw&& draw) {
    Judge judge(tolerance, settings, truth);
    for (;;) {
        judge.add(draw());
        if (const auto judgement = judge.decide()) return *judgement;
    }
}

/// How many of so many submissions end in a verdict.
template <class Draw>
int count(Verdict verdict, int submissions, Tolerance tolerance, Settings settings, double truth, Draw&& draw) {
    int found = 0;
    for (int k = 0; k < submissions; ++k) found += decide(tolerance, settings, truth, draw).verdict == verdict;
    return found;
}

/// Four standard deviations above what a rate makes of so many.
double at_most(double rate, int submissions) { return rate * submissions + 4 * std::sqrt(rate * submissions); }

}  // namespace

TEST_CASE("right submissions fail no oftener than alpha, though no pass is possible and all looks are taken") {
    std::mt19937_64 random(1);
    Settings settings;
    settings.alpha = 0.04;
    const Tolerance tolerance{0, 1e-6};

    SECTION("normal replicates") {
        std::normal_distribution<double> draw(3, 1);
        CHECK(count(Verdict::failed, 2000, tolerance, settings, 3, [&] { return draw(random); }) < at_most(0.04, 2000));
    }
    SECTION("skewed replicates: means of ten exponential events") {
        std::gamma_distribution<double> draw(10, 0.1);
        CHECK(count(Verdict::failed, 2000, tolerance, settings, 1, [&] { return draw(random); }) < at_most(0.04, 2000));
    }
}

TEST_CASE("screening and confirming alone have the level that they claim") {
    // with one look that can fail, the rate is that of both stages on the same side: alpha / 2
    std::mt19937_64 random(2);
    std::normal_distribution<double> draw(0, 1);
    Settings settings;
    settings.alpha = 0.09;
    settings.cap = 16;
    const int failed = count(Verdict::failed, 8000, {0, 1e-6}, settings, 0, [&] { return draw(random); });
    CHECK(failed > 0.045 * 8000 - 4 * std::sqrt(0.045 * 8000));
    CHECK(failed < at_most(0.045, 8000));
}

TEST_CASE("a deviation of delta passes no oftener than beta") {
    std::mt19937_64 random(3);
    std::normal_distribution<double> draw(1, 1);  // delta is one standard deviation away from the truth
    Settings settings;
    settings.alpha = 1e-12;  // do not fail before it could pass
    settings.beta = 0.05;
    CHECK(count(Verdict::passed, 2000, {0, 1}, settings, 0, [&] { return draw(random); }) < at_most(0.05, 2000));
}

TEST_CASE("right and wrong submissions are told apart, and soon") {
    std::mt19937_64 random(4);
    std::normal_distribution<double> noise(0, 0.01);
    const Settings settings{1e-4, 100, 1e-3, 256};
    const Tolerance tolerance{0.001, 0.02};
    for (int k = 0; k < 200; ++k) {
        const Judgement right = decide(tolerance, settings, 5, [&] { return 5.0005 + noise(random); });
        REQUIRE(right.verdict == Verdict::passed);
        REQUIRE(right.replicates <= 64);
        const Judgement wrong = decide(tolerance, settings, 5, [&] { return 5.03 + noise(random); });
        REQUIRE(wrong.verdict == Verdict::failed);
        REQUIRE(wrong.replicates <= 64);
        const Judgement gross = decide(tolerance, settings, 5, [&] { return 10 + noise(random); });
        REQUIRE(gross.verdict == Verdict::failed);
        REQUIRE(gross.replicates == 16);
    }
}

TEST_CASE("what is neither shown right nor wrong at the cap is inconclusive") {
    std::mt19937_64 random(5);
    std::normal_distribution<double> noise(0, 1);
    const Judgement judgement = decide({0, 0.01}, {1e-4, 10, 1e-3, 64}, 0, [&] { return noise(random); });
    CHECK(judgement.verdict == Verdict::inconclusive);
    CHECK(judgement.replicates == 64);
}

TEST_CASE("equal replicates are compared as they are") {
    const Settings settings;
    CHECK(decide({0, 0.1}, settings, 1, [] { return 1.05; }).verdict == Verdict::passed);
    CHECK(decide({0, 0.1}, settings, 1, [] { return 1.05; }).replicates == 8);
    CHECK(decide({0, 0.1}, settings, 1, [] { return 1.2; }).verdict == Verdict::failed);
    CHECK(decide({0, 0.1}, settings, 1, [] { return 1.2; }).constant);
}

TEST_CASE("a statistic that is not finite fails") {
    CHECK(decide({0, 1}, {}, 0, [] { return NAN; }).verdict == Verdict::failed);
    CHECK(judge_exact(NAN, 0, 1).verdict == Verdict::failed);
}

TEST_CASE("without a closed form the reference's replicates are the truth") {
    std::mt19937_64 random(6);
    std::normal_distribution<double> noise(0, 0.1);
    const auto verdict = [&](double bias) {
        Judge judge({0.01, 0.2}, {1e-4, 100, 1e-3, 256});
        while (!judge.decide()) {
            judge.add(2 + bias + noise(random));
            judge.add_reference(2 + 3 * noise(random));
        }
        return judge.decide()->verdict;
    };
    CHECK(verdict(0) == Verdict::passed);
    CHECK(verdict(0.5) == Verdict::failed);
}

TEST_CASE("the judge says how many replicates it wants, and more do not change its verdict") {
    Judge judge({0, 0.1}, {}, 0);
    CHECK(judge.wanted() == 8);
    for (int k = 0; k < 8; ++k) judge.add(k % 2 ? 1 : -1);
    CHECK(!judge.decide());
    CHECK(judge.wanted() == 16);

    Judge gross({0, 0.1}, {}, 0);
    for (int k = 0; k < 8; ++k) gross.add(10 + 0.01 * k);
    CHECK(!gross.decide());
    CHECK(gross.wanted() == 16);
    for (int k = 0; k < 8; ++k) gross.add(10 + 0.01 * k);
    REQUIRE(gross.decide());
    const Judgement decided = *gross.decide();
    CHECK(decided.verdict == Verdict::failed);
    for (int k = 0; k < 100; ++k) gross.add(0);
    CHECK(gross.decide()->verdict == Verdict::failed);
    CHECK(gross.decide()->value == decided.value);
}

TEST_CASE("an exact statistic is decided by one value") {
    CHECK(judge_exact(1.05, 1, 0.1).verdict == Verdict::passed);
    CHECK(judge_exact(1.2, 1, 0.1).verdict == Verdict::failed);
}
