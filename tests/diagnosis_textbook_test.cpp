#include "diagnosis/forms/asked.h"
#include "explained.h"
#include "textbook/form.h"
#include "textbook/wrap.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

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
    CHECK_THAT(both, ContainsSubstring("`sqrt(r)` in place of `r`"));
    CHECK_THAT(both, ContainsSubstring("`pi` in place of `2 * pi`"));
}

namespace {

/// The rows of a fragment's checks.
Rows rows_of_checks(const std::string& fragment) {
    Generator random(7);
    Rows rows;
    for (const Check& check : checks_of(fragment, 7))
        if (const auto* one = std::get_if<Probe>(&check.experiment))
            for (Row& row : one->inputs(random)) rows.push_back(std::move(row));
    return rows;
}

bool is_close(const Row& answer, const Row& right) {
    const auto equal = [](double x, double y) {
        if (!std::isfinite(y)) return x == y || (std::isnan(x) && std::isnan(y));
        return std::abs(x - y) <= 1e-4 * std::max(1.0, std::abs(y));
    };
    return std::ranges::equal(answer, right, equal);
}

/// What a sample's estimates of first and second moments are, over even random numbers: its place, counted with its
/// weight where it has one.
std::vector<double> moments(const Row& row, std::size_t u, bool has_weight,
                            const std::function<Row(const Row&)>& answer) {
    constexpr int n = 64;
    std::vector<double> sums(6);
    for (int i = 0; i < n * n; ++i) {
        Row in = row;
        in[u] = (i % n + 0.5) / n, in[u + 1] = (i / n + 0.5) / n;
        const Row out = answer(in);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t power = 0; power < 2; ++power)
                sums[2 * c + power] +=
                    (has_weight ? out.back() : 1) * (c + 1 < out.size() ? std::pow(out[c], power + 1) : 0) / (n * n);
    }
    return sums;
}

/// Whether a form samples as the solution does, perhaps by other places for the same random numbers.
bool samples_alike(Asked& form, const Signature& signature, const Row& row) {
    const Layout layout = signature.of_arguments(row);
    const auto u = std::ranges::find_if(layout.parts,
                                        [](const Field& part) { return part.name == "u" && part.kind == Kind::pair; });
    if (u == layout.parts.end()) return false;
    const bool has_weight = signature.result == "Scattered";
    const auto own = moments(row, u->at, has_weight, [&](const Row& in) { return form.answer(in, layout); });
    const auto right = moments(row, u->at, has_weight, [&](const Row& in) { return probe(signature.fragment, in); });
    return std::ranges::equal(own, right, [](double x, double y) { return std::abs(x - y) < 0.01; });
}

}  // namespace

TEST_CASE("each textbook's form is the solution, or samples as it does; each that is said to be wrong is not") {
    std::size_t right_ones = 0, wrong_ones = 0;
    for (const textbook::Form& form : textbook::forms()) {
        INFO(form.fragment << ": " << (form.says.empty() ? form.nodes.back().context : form.says));
        const Rows rows = rows_of_checks(form.fragment);
        std::size_t close = 0;
        Asked asked(form);
        const Signature signature = declared(form.fragment);
        for (const Row& row : rows)
            close += is_close(asked.answer(row, signature.of_arguments(row)), probe(form.fragment, row));
        const bool is_right = double(close) > 0.9 * double(rows.size());
        if (form.says.empty()) {
            CHECK((is_right || samples_alike(asked, signature, rows.front())));
        } else {
            CHECK(rows.size() - close >= 5);
        }
        (form.says.empty() ? right_ones : wrong_ones) += 1;
    }
    CHECK(right_ones > 70);
    CHECK(wrong_ones > 40);
}

TEST_CASE("a form asks for other fragments' answers, and another form may stand in for them") {
    const auto form_of = [](const std::string& fragment, bool is_right) {
        const auto found = std::ranges::find_if(textbook::forms(), [&](const textbook::Form& form) {
            return form.fragment == fragment && form.says.empty() == is_right;
        });
        REQUIRE(found != textbook::forms().end());
        return found;
    };
    const auto film = form_of("film_sample", true), wrong_cells = form_of("stratified_2d", false);
    CHECK(film->calls == std::set<std::string>{"stratified_2d"});
    const Rows rows = rows_of_checks("film_sample");
    const Signature signature = declared("film_sample");
    const Ask ask = answers_of(*film, signature);
    const Rows before = ask(rows);
    {
        const textbook::StandIn stand_in(*wrong_cells);
        CHECK(ask(rows) != before);
    }
    CHECK(ask(rows) == before);
}

TEST_CASE("mistakes in a form: operators, brackets, functions, parts in place of the whole") {
    const std::string text =
        "Real area(Real a, Real b) {\n    const Real sum = 2 * (a + b);\n    return std::sin(sum) - a;\n}\n";
    const textbook::Wrapped form = textbook::wrap("area.cpp", text, {}, 0);
    CHECK(form.fragment == "area");
    const auto of = [&](const std::string& expression) {
        const auto node = std::ranges::find(form.nodes, expression, &textbook::Node::text);
        REQUIRE(node != form.nodes.end());
        return *node;
    };
    const auto alternatives = of("2 * (a + b)").alternatives;
    CHECK(std::ranges::count(alternatives, "2 / (a + b)") == 1);
    CHECK(std::ranges::count(alternatives, "2 * a + b") == 1);
    CHECK(of("2 * (a + b)").name == "sum");
    CHECK(of("2 * (a + b)").context == "sum = 2 * (a + b)");
    CHECK(of("sin(sum)").alternatives == std::vector<std::string>{"cos(sum)", "tan(sum)"});
    CHECK(of("sin(sum) - a").alternatives == std::vector<std::string>{"sin(sum) + a", "sin(sum) * a", "a - sin(sum)"});
    CHECK_THROWS_WITH(textbook::wrap("area.cpp", "Real area(Real a) {\n    switch (1) {}\n}\n", {}, 0),
                      ContainsSubstring("area.cpp:2:"));
    CHECK_THROWS_WITH(textbook::wrap("area.cpp", "Real area;\n", {}, 0), ContainsSubstring("no function"));
}
