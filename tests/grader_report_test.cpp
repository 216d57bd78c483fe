#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "catch.h"
#include "diagnosis/diagnosis.h"
#include "files/files.h"
#include "programs/process.h"
#include "protocol/rows.h"
#include "report/escape.h"
#include "report/folder.h"
#include "report/json.h"
#include "report/markdown.h"
#include "report/page.h"
#include "report/page_parts.h"
#include "report/picture.h"
#include "report/terminal.h"

using namespace grade;

namespace {

Record record_with(const std::string& hostile) {
    Record record;
    record.submission = hostile;
    record.title = "Rays";
    record.parts = {{"one", "Part one"}};
    CheckRecord check;
    check.name = "c", check.fragment = "moved", check.verdict = Verdict::failed, check.share = 2,
    check.excerpt = hostile, check.message = hostile;
    StatisticRecord statistic;
    statistic.id = "L3", statistic.what = "width [pixel]", statistic.value = 2.0, statistic.truth = 1.0,
    statistic.low = 1.9, statistic.high = 2.1;
    statistic.tolerance = 0.2, statistic.verdict = Verdict::failed, statistic.hint = hostile;
    check.statistics = {statistic};
    CheckRecord good = check;
    good.verdict = Verdict::passed, good.share = 1, good.message.clear();
    record.fragments = {
        {"moved", "one", 0, 3, "visible", Verdict::failed, hostile, "", "", {check, good}, 0, true, {}}};
    give_points(record.fragments[0]);
    return record;
}

}  // namespace

TEST_CASE("nothing that a submission says gets into the page or the terminal as it is") {
    const std::string hostile = "<script>alert(1)</script>\" onload='x' \033[2J\xff\xe2\x80\xae";
    const Record record = record_with(hostile);
    const std::string text = page(record);
    CHECK(text.find("<script>alert") == std::string::npos);  // but for the one of the page
    CHECK(text.find("onload='x'") == std::string::npos);
    CHECK(text.find('\033') == std::string::npos);
    CHECK(text.find('\xff') == std::string::npos);
    const std::string terminal = table(record, {});
    CHECK(terminal.find('\033') == std::string::npos);
    CHECK(terminal.find("\xe2\x80\xae") == std::string::npos);
    CHECK(nlohmann::json::accept(to_json(record)));
}

TEST_CASE("a terminal tells what is wrong, the call, what to read, and last what the compiler warns of") {
    Record record = record_with("is it squared?");
    FragmentRecord& wrong = record.fragments[0];
    wrong.message.clear(), wrong.checks[0].message.clear(), wrong.checks[1].statistics.clear();
    wrong.file = "fragments/moved.cpp", wrong.warnings = "fragments/moved.cpp:9:5: warning: unused";
    wrong.finding.arguments = "time = -1", wrong.finding.answer = "1", wrong.finding.right = "2";
    wrong.finding.command = "./grade call moved 'time = -1'";
    // one fragment has no sums
    const std::string row = "  moved                   failed              1 of 3    fragments/moved.cpp\n";
    const std::string below = "      For time = -1 the answer is 1, must be 2\n";
    const std::string last = "      read: handout.md, \"moved\"\n      fragments/moved.cpp:9:5: warning: unused\n";
    CHECK(table(record, {}) == row + below + last);
    const std::string again = "      again: ./grade call moved 'time = -1'\n";
    const std::string defaults =
        "Fields that a call does not name have the defaults of starter/rt/parts.h and ray.h.\n";
    CHECK(table(record, {.own = true}) == row + below + again + last + defaults);
    // files are named as they are from where the reader stands
    const std::string text = table(record, {.own = true, .folder = "../starter/"});
    CHECK(text.find(" ../starter/fragments/moved.cpp\n") != text.npos);
    CHECK(text.find(" ../starter/fragments/moved.cpp:9:5: warning: unused\n") != text.npos);
    // what does not fit has the answers in lines of their own
    Record long_call = record;
    long_call.fragments[0].finding.arguments = "camera.focus = 3, pinhole.direction = (0.123456, 0.234567, 0.345678)";
    long_call.fragments[0].finding.answer = "origin = (0, 0, 1)",
    long_call.fragments[0].finding.right = "origin = (0, 1, 1)";
    CHECK(table(long_call, {})
              .find("0.345678)\n      the answer is origin = (0, 0, 1),\n      must be origin = (0, 1, 1)\n") !=
          std::string::npos);
    // of several, those of parts where there are several
    FragmentRecord blank;
    blank.name = "phong", blank.part = "one", blank.max_points = 3, blank.verdict = Verdict::not_started;
    blank.message = "fill in fragments/phong.cpp";
    record.fragments.push_back(blank);
    const std::string second = "  phong                   not started         0 of 3    fill in fragments/phong.cpp\n";
    const std::string total = "Total                                         1 of 6    1 failed, 1 not started\n";
    CHECK(table(record, {}) == row + below + last + second + total);
    record.parts.push_back({"two", "Part two"});
    record.fragments[1].part = "two";
    CHECK(table(record, {}).starts_with("Part one                                      1 of 3\n" + row));
    CHECK(table(record, {}).ends_with("3\n" + second + "\n" + total));
}

TEST_CASE("reports show what a picture costs and how noisy it is, beside the solution's") {
    Record record = record_with("mine");
    CHECK_FALSE(record.efficiency_ratio().has_value());
    CHECK(page(record).find("One picture") == std::string::npos);
    CheckRecord& check = record.fragments[0].checks[0];
    check.cost = PictureCost{4e-4, 0.5};
    check.solution_cost = PictureCost{1e-4, 0.25};
    CHECK(check.cost->rmse() == Approx(0.02));
    CHECK(check.cost->efficiency().value() == Approx(5000));
    // what is wrong has no efficiency
    CHECK_FALSE(record.efficiency_ratio().has_value());
    CHECK(page(record).find("One picture, yours: error 0.02 in 0.5 s of CPU time. The right one: error 0.01") !=
          std::string::npos);
    CHECK(page(record).find("the right one's") == std::string::npos);
    CHECK(table(record, {}).find("Efficiency") == std::string::npos);
    record.fragments[0].verdict = Verdict::passed;
    CHECK(record.efficiency_ratio().value() == Approx(0.125));
    const auto json = nlohmann::json::parse(to_json(record));
    CHECK(json["fragments"][0]["checks"][0]["picture"]["mse"] == Approx(4e-4));
    CHECK(json["fragments"][0]["checks"][0]["solution_picture"]["cpu_seconds"] == Approx(0.25));
    const std::string text = page(record);
    CHECK(text.find("Efficiency: 0.12 times the right one's.") != std::string::npos);
    CHECK(text.find("error against run time</text>") != std::string::npos);
    CHECK(table(record, {}).find("0.12 times the solution's") != std::string::npos);

    // without an error there is no efficiency
    check.cost->mse = 0;
    CHECK_FALSE(record.efficiency_ratio().has_value());
}

TEST_CASE("printable text keeps what people write and ends somewhere") {
    CHECK(printable("größer\tals\n§") == "größer\tals\n§");
    CHECK(printable("a\rb\x01"
                    "c") == "ab?c");
    CHECK(printable(std::string(5000, 'x'), 100).size() < 110);
}

TEST_CASE("printable text is no command to who runs the grader") {
    CHECK(printable("::error::a rt::phong\n  ::set-env x::y") == ": :error::a rt::phong\n  : :set-env x::y");
    CHECK(printable("a ##[error]b") == "a # #[error]b");
}

TEST_CASE("points are the share of passed checks") {
    CHECK(record_with("").fragments[0].points == 1);
    FragmentRecord none;
    none.max_points = 3;
    CHECK(points_of(none) == 0);
}

TEST_CASE("the worst verdict of a fragment is told") {
    CHECK(worse(Verdict::passed, Verdict::inconclusive) == Verdict::inconclusive);
    CHECK(worse(Verdict::crashed, Verdict::failed) == Verdict::crashed);
    CHECK(worse(Verdict::inconclusive, Verdict::failed) == Verdict::failed);
}

namespace {

StatisticRecord failing(const std::string& id, const std::string& hint) {
    StatisticRecord statistic;
    statistic.id = id, statistic.hint = hint, statistic.verdict = Verdict::failed;
    return statistic;
}

FragmentRecord fragment_with(Verdict verdict, const std::string& message, std::vector<StatisticRecord> statistics) {
    FragmentRecord fragment;
    CheckRecord check;
    fragment.name = check.fragment = "lens_ray";
    fragment.verdict = check.verdict = verdict;
    check.message = message;
    check.statistics = std::move(statistics);
    fragment.checks = {check};
    return fragment;
}

}  // namespace

TEST_CASE("of what fails, shared numbers are told first, then what is no image, tone, geometry, radiometry, variance") {
    std::vector<StatisticRecord> all;
    for (const char* id : {"G3", "L1", "D1", "A1", "G4", "V0", "G1"}) {
        all.insert(all.begin(), failing(id, id));
        std::rotate(all.begin(), all.begin() + 1, all.end());  // the last one is told first
        CHECK(diagnose(fragment_with(Verdict::failed, "", all)).words == (std::string(id) == "A1" ? "D1" : id));
    }
    // what a call shows comes before what a picture shows, but for shared numbers
    FragmentRecord both = fragment_with(Verdict::failed, "", {failing("A1", "picture")});
    both.checks[0].scene = "[camera]";
    both.checks.push_back(fragment_with(Verdict::failed, "", {failing("V3", "call")}).checks[0]);
    CHECK(diagnose(both).words == "call");
    both.checks[0].statistics[0].id = "G1";
    CHECK(diagnose(both).words == "picture");
    // of one family, the first check's
    CHECK(diagnose(fragment_with(Verdict::failed, "", {failing("A1", "first"), failing("D1", "second")})).words ==
          "first");
    // a crash comes before all statistics
    FragmentRecord crashed = fragment_with(Verdict::failed, "", {failing("G1", "shared")});
    crashed.checks.push_back(crashed.checks[0]);
    crashed.checks[1].verdict = Verdict::crashed, crashed.checks[1].message = "ended",
    crashed.checks[1].statistics.clear();
    CHECK(diagnose(crashed).words == "ended");
    CHECK(diagnose(crashed).section == "lens_ray");
}

TEST_CASE("a diagnosis says where to read, in the record, in the table and as a link") {
    const FragmentRecord wrong =
        fragment_with(Verdict::failed, "", {failing("D1", "the blur disc is 2.01 times what it must be")});
    CHECK(diagnose(wrong).section == "lens_ray");
    CHECK(reading("lens_ray") == "handout.md, \"lens_ray\"");
    CHECK(anchor("What to use instead of an epsilon") == "what-to-use-instead-of-an-epsilon");
    const auto in_trouble = [](Verdict verdict, Trouble trouble) {
        FragmentRecord fragment = fragment_with(verdict, "words", {});
        fragment.checks[0].trouble = trouble;
        return diagnose(fragment).section;
    };
    CHECK(in_trouble(Verdict::not_finite, Trouble::not_a_number) == numbers_section);
    CHECK(in_trouble(Verdict::not_finite, Trouble::no_radiance) == pictures_section);
    CHECK(in_trouble(Verdict::failed, Trouble::keeps_state) == rules_section);
    CHECK(in_trouble(Verdict::failed, Trouble::no_radiance) == pictures_section);
    CHECK(diagnose(fragment_with(Verdict::failed, "", {failing("V0", "changes")})).section == rules_section);
    Record record;
    record.parts = {{"one", "Part one"}};
    record.fragments = {wrong};
    record.fragments[0].part = "one";
    CHECK(nlohmann::json::parse(to_json(record))["fragments"][0]["read"] == "handout.md, \"lens_ray\"");
    CHECK(nlohmann::json::parse(to_json(record))["fragments"][0]["checks"][0]["statistics"][0]["read"] ==
          "handout.md, \"lens_ray\"");
    CHECK(table(record, {}).find("handout.md, \"lens_ray\"") != std::string::npos);
    CHECK(page(record, "../handout.md").find("href=\"../handout.md#lens_ray\"") != std::string::npos);
    record.fragments = {fragment_with(Verdict::passed, "", {})};
    CHECK(!nlohmann::json::parse(to_json(record))["fragments"][0].contains("read"));
}

TEST_CASE("the compiler's warnings are in the table, on the page and in the record, also of what passes") {
    Record record;
    record.parts = {{"one", "Part one"}};
    record.fragments = {fragment_with(Verdict::passed, "", {})};
    record.fragments[0].part = "one";
    record.fragments[0].warnings = "phong.cpp:4:9: warning: unused <b>variable</b> [-Wunused-variable]\x1b[31m\n";
    const std::string rows = table(record, {}), text = page(record, "../handout.md");
    CHECK(rows.find("phong.cpp:4:9: warning: unused <b>variable</b>") != std::string::npos);
    CHECK(rows.find('\x1b') == std::string::npos);
    CHECK(text.find("&lt;b&gt;variable") != std::string::npos);
    CHECK(text.find("<b>variable") == std::string::npos);
    CHECK(nlohmann::json::parse(to_json(record))["fragments"][0].contains("warnings"));
}

TEST_CASE("the simplest call that goes wrong is on the page and in the record as C++ and for a shell") {
    Record record;
    record.parts = {{"one", "Part one"}};
    record.fragments = {fragment_with(Verdict::failed, "", {failing("M1", "off")})};
    record.fragments[0].part = "one";
    Finding& finding = record.fragments[0].finding;
    finding.arguments = "time = -1", finding.answer = "0", finding.right = "1";
    finding.code = "moved(vec3(0), vec3(1), -1);\n", finding.command = "./grade call moved 'time = -1'";
    const std::string text = page(record, "../handout.md");
    CHECK(text.find("moved(vec3(0), vec3(1), -1);") != std::string::npos);
    CHECK(text.find("./grade call moved &#39;time = -1&#39;") != std::string::npos);
    const auto call = nlohmann::json::parse(to_json(record))["fragments"][0]["finding"];
    CHECK(call["command"] == finding.command);
    CHECK(call["right"] == "1");
    CHECK(table(record, {}).find("./grade call") == std::string::npos);
}

TEST_CASE("what stands between backquotes is code, and as harmless as the rest") {
    CHECK(html_with_code("`a < b` and `c`") == "<code>a &lt; b</code> and <code>c</code>");
    CHECK(html_with_code("one ` alone") == "one ` alone");
    CHECK(html_with_code("`<b>") == "`&lt;b&gt;");
    // elsewhere powers are raised
    CHECK(html_with_code("[pixel^2], (1 - g)^3, `x^2`, N^-1.50.") ==
          "[pixel<sup>2</sup>], (1 - g)<sup>3</sup>, <code>x^2</code>, N<sup>-1.50</sup>.");
    CHECK(html_with_code("v N^(-2q), f^(x) (^2)") == "v N<sup>-2q</sup>, f<sup>x</sup> (^2)");
    CHECK(html_with_code("[m2] ^2 a^b a^ a^-") == "[m<sup>2</sup>] ^2 a^b a^ a^-");
}

TEST_CASE("a value far off stays inside its drawing, as an arrow") {
    StatisticRecord statistic;
    statistic.value = 1e6, statistic.truth = 1, statistic.low = 1e6, statistic.high = 1e6, statistic.tolerance = 0.1,
    statistic.verdict = Verdict::failed;
    CHECK(bar(statistic).find("<path") != std::string::npos);
    statistic.value = 1.05;
    CHECK(bar(statistic).find("<circle") != std::string::npos);
    statistic.value = std::nullopt;
    CHECK(bar(statistic).empty());
}

TEST_CASE("a drawing tells what is right from what is not yet wrong") {
    StatisticRecord statistic;
    statistic.value = 1.02, statistic.truth = 1, statistic.delta0 = 0.004, statistic.tolerance = 0.04;
    const auto width = [](const std::string& svg, const std::string& kind) {
        const auto at = svg.find("<rect class=\"" + kind + "\"");
        REQUIRE(at != svg.npos);
        return std::stod(svg.substr(svg.find("width=\"", at) + 7));
    };
    const std::string svg = bar(statistic);
    CHECK(width(svg, "between") > 8 * width(svg, "band"));
    CHECK(svg.find("right within 0.004, wrong beyond 0.04") != svg.npos);
    // without noise there is nothing in between
    statistic.exact = true;
    CHECK(width(bar(statistic), "between") == width(bar(statistic), "band"));
    CHECK(right_within(statistic) == 0.04);
}

TEST_CASE("a page says each thing once, and of what did not run that it did not") {
    Record record;
    record.parts = {{"one", "Part one"}};
    record.fragments = {fragment_with(Verdict::failed, "", {failing("W1", "the far crossing is missing")})};
    FragmentRecord& fragment = record.fragments[0];
    fragment.part = "one";
    fragment.checks.push_back(fragment.checks[0]);
    fragment.checks.push_back(fragment_with(Verdict::timed_out, std::string(not_run) + "x", {}).checks[0]);
    fragment.finding.how = "the far crossing is missing";
    const auto count = [](const std::string& text, const std::string& words) {
        std::size_t all = 0;
        for (std::size_t at = 0; (at = text.find(words, at)) != text.npos; ++at) ++all;
        return all;
    };
    const std::string text = page(record), section = text.substr(text.find("<section class=\"card\" id=\"lens_ray\""));
    CHECK(count(section, "the far crossing is missing") == 1);
    CHECK(count(section, ">not run</span>") == 1);
    CHECK(count(section, "timed out") == 0);
    // where it breaks down stands in the overview too
    fragment.finding.fault = "lens_ray.cpp:18: a null pointer is followed";
    CHECK(count(page(record), "lens_ray.cpp:18: a null pointer is followed") == 3);
}

TEST_CASE("the difference of pictures is white where they agree, blue where darker, orange where brighter") {
    rt::Image a(3, 1), b(3, 1);
    a.pixels = {rt::Color(1), rt::Color(0.5), rt::Color(2)};
    b.pixels = {rt::Color(1), rt::Color(1), rt::Color(1)};
    const Difference map = difference(a, b);
    CHECK(map.image.pixels[0] == rt::Color(1));
    CHECK(map.image.pixels[1].b > map.image.pixels[1].r);
    CHECK(map.image.pixels[2].r > map.image.pixels[2].b);
    CHECK(data_uri(map.image, 1).starts_with("data:image/png;base64,iVBORw0KGgo"));
}

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

TEST_CASE("a program's end, output and limits are told") {
    const auto shell = [](const std::string& text, Limits limits = {}) {
        return run({"/bin/sh", "-c", text}, limits, "/");
    };
    CHECK(shell("echo out; echo err >&2; exit 3").code == 3);
    CHECK(shell("echo out").out == "out\n");
    CHECK(shell("kill -SEGV $$").how == Ending::How::signalled);
    Limits limits;
    limits.wall_seconds = 0.5;
    CHECK(shell("sleep 100", limits).how == Ending::How::timed_out);
    limits = {};
    limits.cpu_seconds = limits.most_cpu_seconds = 1;
    CHECK(shell("while :; do :; done", limits).how == Ending::How::timed_out);
    limits = {};
    limits.output = 1000;
    CHECK(shell("yes | head -c 1000000", limits).out.size() == 1000);
    CHECK(shell("sleep 100 & echo done").out == "done\n");
    CHECK(shell("env").out.find("HOME") == std::string::npos);
    CHECK(run({"/no/such/program"}, {}, "/").how == Ending::How::not_run);
}

TEST_CASE("a report in Markdown becomes sections of a page, and what it quotes is harmless") {
    const std::string text = html_of_markdown(
        "# title\n\nfirst **words**\nand `code` <script>\n\n## A | B\n\n![alt \" x](a.svg)\n| a | b |\n|---|---|\n"
        "| 1 | **2** |\n\n* one\n* two ** alone\n");
    CHECK(text.find("title") == std::string::npos);
    CHECK(text.find("<p>first <b>words</b>\nand <code>code</code> &lt;script&gt;\n</p>") != std::string::npos);
    CHECK(text.find("<h2>A | B</h2>") != std::string::npos);
    CHECK(text.find("<img src=\"a.svg\" alt=\"alt &quot; x\">") != std::string::npos);
    CHECK(text.find("<tr><th> a </th><th> b </th></tr>\n<tr><td> 1 </td><td data-is=\"b\"> <b>2</b> </td></tr>") !=
          std::string::npos);
    CHECK(text.find("<ul><li>one</li>\n<li>two ** alone</li>\n</ul>") != std::string::npos);
}

TEST_CASE("pages of one folder lead to each other, whichever was written first") {
    const fs::path folder = fs::temp_directory_path() / fmt::format("penumbra-pages-{}", getpid());
    write_page(folder, "stress.html", plain_page("Stress", "mine", "<p>s</p>"));
    const std::string alone = read_text(folder / "stress.html").value();
    CHECK(alone.find("<b aria-current=\"page\">extreme cases</b>") != std::string::npos);
    CHECK(alone.find("lesson.html") == std::string::npos);
    CHECK(alone.find("<code>./grade lesson SUBMISSION --out DIR</code>") != std::string::npos);

    write_page(folder, "lesson.html", plain_page("Lesson", "mine", "<p>l</p>"));
    const std::string both = read_text(folder / "stress.html").value();
    CHECK(both.find("<a href=\"lesson.html\"") != std::string::npos);
    CHECK(both.find("<p>s</p>") != std::string::npos);
    CHECK(both.find("./grade lesson") == std::string::npos);
    CHECK(read_text(folder / "lesson.html").value().find("<a href=\"stress.html\"") != std::string::npos);
    fs::remove_all(folder);
}
