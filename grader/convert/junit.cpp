#include <fmt/format.h>

#include "convert/formats.h"
#include "convert/words.h"
#include "report/escape.h"

namespace grade {

namespace {

/// Text of an attribute, whose line ends would become spaces.
std::string attribute(const std::string& text) {
    std::string safe;
    for (const char c : html(text)) safe += c == '\n' ? "&#10;" : c == '\t' ? "&#9;" : std::string(1, c);
    return safe;
}

enum class Kind { passed, failure, error, skipped };

Kind kind_of(Verdict verdict) {
    switch (verdict) {
        case Verdict::passed:
            return Kind::passed;
        case Verdict::failed:
        case Verdict::not_finite:
            return Kind::failure;
        case Verdict::not_started:
            return Kind::skipped;
        default:
            return Kind::error;
    }
}

/// What is wrong with one check: its own words, those of its statistics.
std::string words_of(const CheckRecord& check) {
    std::string text = check.message;
    for (const StatisticRecord& statistic : check.statistics)
        if (statistic.verdict != Verdict::passed)
            text += (text.empty() ? "" : "\n") + statistic.id + " " + statistic.what + ": " + statistic.hint;
    return text;
}

struct Suite {
    std::string cases;
    int tests = 0, failures = 0, errors = 0, skipped = 0;
    double seconds = 0;

    void add(const std::string& group, const std::string& name, Verdict verdict, const std::string& words,
             double cpu_seconds) {
        const Kind kind = kind_of(verdict);
        ++tests, failures += kind == Kind::failure, errors += kind == Kind::error, skipped += kind == Kind::skipped;
        seconds += cpu_seconds;
        cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", attribute(group),
                             attribute(name), cpu_seconds);
        if (kind == Kind::passed) {
            cases += "/>\n";
        } else if (kind == Kind::skipped) {
            cases += "><skipped message=\"not started\"/></testcase>\n";
        } else {
            const char* tag = kind == Kind::failure ? "failure" : "error";
            const std::string first = words.substr(0, words.find('\n'));
            cases += fmt::format("><{0} type=\"{1}\" message=\"{2}\">{3}</{0}></testcase>\n", tag, grade::name(verdict),
                                 attribute(first), html(words));
        }
    }
};

Suite suite_of(const FragmentRecord& fragment) {
    Suite suite;
    const std::string group = fragment.part + "." + fragment.name;
    for (const CheckRecord& check : fragment.checks) {
        const std::string words = words_of(check);
        suite.add(group, check.name, check.verdict, words.empty() ? words_on(fragment) : words, check.cpu_seconds);
    }
    if (fragment.checks.empty()) suite.add(group, "checks", fragment.verdict, words_on(fragment), 0);
    return suite;
}

std::string counts(const Suite& suite) {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\"", suite.tests,
                       suite.failures, suite.errors, suite.skipped, suite.seconds);
}

}  // namespace

std::string junit(const Record& record) {
    Suite all;
    std::string suites;
    for (const FragmentRecord& fragment : record.fragments) {
        const Suite suite = suite_of(fragment);
        all.tests += suite.tests, all.failures += suite.failures, all.errors += suite.errors;
        all.skipped += suite.skipped, all.seconds += suite.seconds;
        suites +=
            fmt::format("  <testsuite name=\"{}\" timestamp=\"{}\" hostname=\"localhost\" {}>\n    <properties>\n",
                        attribute(fragment.part + "." + fragment.name), record.date.substr(0, record.date.find('Z')),
                        counts(suite));
        for (const auto& [key, value] : {std::pair("points", short_number(fragment.points)),
                                         {"max_points", short_number(fragment.max_points)},
                                         {"verdict", std::string(name(fragment.verdict))}})
            suites += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", key, value);
        suites += "    </properties>\n" + suite.cases + "  </testsuite>\n";
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{}\" {}>\n{}</testsuites>\n",
                       attribute(record.title), counts(all), suites);
}

}  // namespace grade
