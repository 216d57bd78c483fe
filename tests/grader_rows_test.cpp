#include "catch.h"
#include "protocol/rows.h"

using namespace grade;

TEST_CASE("arguments survive as rows") {
    rt::Material material;
    material.albedo = {0.1, 0.2, 0.3}, material.shininess = 7, material.ior = 1.5, material.sampled = false,
    material.medium.g = 0.4;
    const Numbers numbers = row(material, rt::Ray{{1, 2, 3}, {4, 5, 6}, 0, rt::inf}, rt::Event::lobe, 3, true);
    CHECK(numbers.size() == 27 + 8 + 1 + 1 + 1);
    RowReader in(numbers);
    const auto back = read(in, Tag<rt::Material>{});
    CHECK(back.albedo == material.albedo);
    CHECK((back.shininess == 7 && back.ior == 1.5 && !back.sampled && back.medium.g == 0.4));
    const auto ray = read(in, Tag<rt::Ray>{});
    CHECK((ray.direction == rt::vec3(4, 5, 6) && ray.far == rt::inf));
    CHECK(read(in, Tag<rt::Event>{}) == rt::Event::lobe);
    CHECK(read(in, Tag<int>{}) == 3);
    CHECK(read(in, Tag<bool>{}));
    CHECK(in.at_end());
    CHECK_THROWS_AS(in.number(), std::out_of_range);
    CHECK_THROWS_AS((from_row<std::vector<double>>(Numbers{5, 1, 2})), std::domain_error);
}

TEST_CASE("an integrand is its formula") {
    using Kind = Integrand::Kind;
    CHECK(Integrand{Kind::polynomial, {1, 2, 3}}(2) == 17);
    CHECK(Integrand{Kind::cosine, {1, 2, 3, 0}}(1) == Approx(3));
    CHECK(Integrand{Kind::gaussian, {5, 1, 2}}(1) == 5);
    CHECK(Integrand{Kind::lorentzian, {4, 1, 2}}(3) == 2);
    CHECK(Integrand{Kind::exponential, {2, 1}}(0) == 2);
    CHECK(Integrand{Kind::power, {2, 3}}(2) == 16);
    CHECK(Integrand{Kind::step, {0.5, 1, 2}}(0.5) == 2);
}
