#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "catch.h"
#include "files/files.h"
#include "records.h"
#include "report/escape.h"
#include "report/folder.h"
#include "report/json.h"
#include "report/markdown.h"
#include "report/page.h"
#include "report/page_parts.h"
#include "report/picture.h"
#include "report/terminal.h"

using namespace grade;

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
    constexpr double infinite = std::numeric_limits<double>::infinity();
    statistic.value = statistic.low = statistic.high = infinite;
    for (const double tolerance : {0.1, 0.0}) {
        statistic.tolerance = tolerance;
        CHECK(bar(statistic).find("<path") != std::string::npos);
        CHECK(bar(statistic).find("\"nan") == std::string::npos);
    }
    statistic.value = std::nan("");
    CHECK(bar(statistic).find("not to be drawn") != std::string::npos);
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

TEST_CASE("a page says what a chi squared is where one was measured, whatever the words for it are") {
    StatisticRecord spread = failing("D2", ""), other = failing("D2", "");
    spread.what = "chi-squared of equal areas", spread.chi_squared = true;
    other.what = "chi squared is in the words alone";
    const auto page_with = [](const StatisticRecord& statistic) {
        Record record;
        record.parts = {{"one", "Part one"}};
        record.fragments = {fragment_with(Verdict::failed, "", {statistic})};
        record.fragments[0].part = "one";
        return page(record);
    };
    CHECK(page_with(spread).find("Chi squared per degree of freedom is 1") != std::string::npos);
    CHECK(page_with(other).find("Chi squared per degree of freedom is 1") == std::string::npos);
}

TEST_CASE("a page says each thing once, and of what did not run that it did not") {
    Record record;
    record.parts = {{"one", "Part one"}};
    record.fragments = {fragment_with(Verdict::failed, "", {failing("W1", "the far crossing is missing")})};
    FragmentRecord& fragment = record.fragments[0];
    fragment.part = "one";
    fragment.checks.push_back(fragment.checks[0]);
    fragment.checks.push_back(fragment_with(Verdict::timed_out, "not run, since x", {}).checks[0]);
    fragment.checks.back().trouble = Trouble::not_run;
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
    CHECK(html_of_markdown("# title\n\n## A\n\nwords\n").starts_with("<h2>A</h2>"));  // no empty card before it
}

TEST_CASE("pages of one folder lead to each other, whichever was written first") {
    const fs::path folder = fs::temp_directory_path() / fmt::format("penumbra-pages-{}", getpid());
    write_page(folder, "stress.html", plain_page("Stress", "mine", "", "<p>s</p>"));
    const std::string alone = read_text(folder / "stress.html").value();
    CHECK(alone.find("<b aria-current=\"page\">extreme cases</b>") != std::string::npos);
    CHECK(alone.find("lesson.html") == std::string::npos);
    CHECK(alone.find("<code>./grade lesson [SUBMISSION --out DIR]</code>") != std::string::npos);

    write_page(folder, "lesson.html", plain_page("Lesson", "mine", "", "<p>l</p>"));
    const std::string both = read_text(folder / "stress.html").value();
    CHECK(both.find("<a href=\"lesson.html\"") != std::string::npos);
    CHECK(both.find("<p>s</p>") != std::string::npos);
    CHECK(both.find("./grade lesson") == std::string::npos);
    CHECK(read_text(folder / "lesson.html").value().find("<a href=\"stress.html\"") != std::string::npos);
    CHECK(both.find("<a href=\"handout.html\">") == std::string::npos);

    // a handout that is a page comes along, and each page leads to it
    const fs::path kit = folder / "kit";
    fs::create_directories(kit);
    CHECK(handout_beside(folder, kit) == "kit/handout.md");
    write_text(kit / "handout.html", "the handout");
    CHECK(handout_beside(folder, kit) == "handout.html");
    CHECK(read_text(folder / "handout.html") == "the handout");
    write_page(folder, "lesson.html", plain_page("Lesson", "mine", read_link("phong", "handout.html"), "<p>l</p>"));
    for (const char* page : {"stress.html", "lesson.html"})
        CHECK(read_text(folder / page).value().find("<a href=\"handout.html\">handout</a>") != std::string::npos);
    CHECK(read_text(folder / "lesson.html").value().find("<a href=\"handout.html#phong\">") != std::string::npos);
    fs::remove_all(folder);
}
