#include <stdexcept>

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

TEST_CASE("each type has as many numbers as the table of rows.h says, and comes back from them") {
    const auto numbers_of = []<class Value>(Tag<Value>) {
        Numbers numbers = row(Value{});
        for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = double(i % 2);  // a flag, a kind, a count of none
        return row(from_row<Value>(numbers)) == numbers ? int(numbers.size()) : 0;
    };
    CHECK(numbers_of(Tag<rt::vec2>{}) == 2);
    CHECK(numbers_of(Tag<rt::ivec2>{}) == 2);
    CHECK(numbers_of(Tag<rt::vec3>{}) == 3);
    CHECK(numbers_of(Tag<rt::Ray>{}) == 8);
    CHECK(numbers_of(Tag<rt::Hit>{}) == 7);
    CHECK(numbers_of(Tag<rt::Sphere>{}) == 4);
    CHECK(numbers_of(Tag<rt::Triangle>{}) == 9);
    CHECK(numbers_of(Tag<rt::Quad>{}) == 9);
    CHECK(numbers_of(Tag<rt::Disc>{}) == 7);
    CHECK(numbers_of(Tag<rt::Camera>{}) == 17);
    CHECK(numbers_of(Tag<rt::Shutter>{}) == 2);
    CHECK(numbers_of(Tag<rt::Extent>{}) == 4);
    CHECK(numbers_of(Tag<rt::PointLight>{}) == 7);
    CHECK(numbers_of(Tag<rt::Emitter>{}) == 24);
    CHECK(numbers_of(Tag<rt::Material>{}) == 27);
    CHECK(numbers_of(Tag<rt::LightSample>{}) == 5);
    CHECK(numbers_of(Tag<rt::DiskSample>{}) == 3);
    CHECK(numbers_of(Tag<rt::DirectionSample>{}) == 4);
    CHECK(numbers_of(Tag<rt::FilmSample>{}) == 3);
    CHECK(numbers_of(Tag<rt::Scattered>{}) == 6);
    CHECK(numbers_of(Tag<rt::Outgoing>{}) == 9);
    CHECK(row(Integrand{Integrand::Kind::power, {2, 3}}) == Numbers{5, 2, 2, 3});
    CHECK(row(std::vector<StratumOf>{{0, 1, {0.5}}, {1, 2, {}}}) == Numbers{2, 0, 1, 1, 0.5, 1, 2, 0});
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
