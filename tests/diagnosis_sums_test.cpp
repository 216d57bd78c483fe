#include "diagnosis/surest.h"
#include "explained.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("what is wrong with a sum over strata has a name") {
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

TEST_CASE("of samples that lie elsewhere, what a few of them have in common is not what is wrong") {
    Calls all;
    all.signature = declared("glossy_reflection");
    for (int k = 0; k < 10; ++k) {
        all.rows.push_back(row(rt::vec3(0, 0, -1), rt::vec3(0, 0, 1), 1.0, rt::vec2(0.1 * k, 0.5)));
        all.layouts.push_back(all.signature.of_arguments(all.rows.back()));
        all.right.push_back(row(rt::vec3(0, 0, 1), rt::Color(1)));
        all.mine.push_back(row(rt::vec3(0, 1, 0), rt::Color(k < 4 ? 0 : 2)));
    }
    all.result = all.signature.of_result(all.right.front());
    Relation constant{"`weight` is always (0, 0, 0)"};
    constant.is_constant = true;
    CHECK(tells_of_few(constant, all));
    for (int k = 4; k < 6; ++k) all.mine[std::size_t(k)] = row(rt::vec3(0, 1, 0), rt::Color(0));
    CHECK_FALSE(tells_of_few(constant, all));
    constant.is_constant = false;
    CHECK_FALSE(tells_of_few(constant, all));
}

namespace {

Rows pixels() {
    return calls([](Generator& random) {
        std::vector<rt::Color> radiance;
        for (int i = 0; i < 4; ++i) radiance.push_back(box(random, 0, 1));
        return row(radiance, std::vector<double>(4, 1.0));
    });
}

}  // namespace

TEST_CASE("what is no sum is not told as one") {
    const Ask brightest = [](const Rows& asked) {
        Rows all;
        for (const Row& in : asked) {
            const auto count = std::size_t(in[0]);
            Row out(3);
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < 3; ++c) out[c] = std::max(out[c], in[1 + 3 * i + c]);
            all.push_back(out);
        }
        return all;
    };
    CHECK_THAT(found("pixel_mean", pixels(), brightest).how, !ContainsSubstring("the sum is"));
}

TEST_CASE("nor is what ends where it is asked for all at once") {
    const Ask doubled = answers("pixel_mean", {}, [](Row& answer) { answer[0] *= 2, answer[1] *= 2, answer[2] *= 2; });
    const Ask ends = [&](const Rows& asked) {
        const auto is_white = [](const Row& in) { return in[1] == 1 && in[4] == 1; };
        return std::ranges::any_of(asked, is_white) ? Rows{} : doubled(asked);
    };
    CHECK_THAT(found("pixel_mean", pixels(), doubled).how, ContainsSubstring("2 times too large"));
    CHECK_THAT(found("pixel_mean", pixels(), ends).how, ContainsSubstring("2 times too large"));
}
