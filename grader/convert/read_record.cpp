#include "convert/read_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <span>

#include "files/files.h"
#include "report/json.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

using Json = nlohmann::ordered_json;

/// An object of the record, and where it stands: "/fragments/3".
struct Node {
    const Json& json;
    std::string path, place;

    [[noreturn]] void fail(const std::string& key, const char* expected) const {
        throw rt::InputError(fmt::format("{}: {}/{} is {}; expected {}: is the file whole?", path, place, key,
                                         json.contains(key) ? "no such thing" : "missing", expected));
    }

    const Json& at(const char* key, bool (Json::*is)() const, const char* expected) const {
        if (!json.is_object() || !json.contains(key) || !(json.at(key).*is)()) fail(key, expected);
        return json.at(key);
    }

    std::string text(const char* key) const { return at(key, &Json::is_string, "a text"); }
    std::string text_or_none(const char* key) const { return json.contains(key) ? text(key) : ""; }
    double number(const char* key) const { return at(key, &Json::is_number, "a number"); }
    bool flag(const char* key) const { return at(key, &Json::is_boolean, "true or false"); }

    double amount(const char* key) const {
        const double x = number(key);
        if (!(x >= 0)) fail(key, "a number of at least 0");
        return x;
    }

    int count(const char* key) const {
        const double x = number(key);
        if (!(x >= 0 && x <= 1e9)) fail(key, "a count");
        return int(x);
    }

    std::optional<double> number_or_null(const char* key) const {
        if (json.is_object() && json.contains(key) && json.at(key).is_null()) return std::nullopt;
        return number(key);
    }

    /// The number of a name.
    int one_of(std::span<const std::string_view> names, const char* key) const {
        const auto found = std::ranges::find(names, text(key));
        if (found == names.end()) fail(key, "one of record/README.md");
        return int(found - names.begin());
    }
    Verdict verdict() const { return Verdict(one_of(verdict_names, "verdict")); }

    Node object(const char* key) const { return {at(key, &Json::is_object, "an object"), path, place + "/" + key}; }

    std::vector<Node> objects(const char* key) const {
        std::vector<Node> all;
        for (const Json& entry : at(key, &Json::is_array, "a list")) {
            all.push_back({entry, path, fmt::format("{}/{}/{}", place, key, all.size())});
            if (!entry.is_object()) all.back().fail("", "an object");
        }
        return all;
    }

    std::vector<std::string> texts(const char* key) const {
        std::vector<std::string> all;
        for (const Json& entry : at(key, &Json::is_array, "a list of texts")) {
            if (!entry.is_string()) fail(key, "a list of texts");
            all.push_back(entry);
        }
        return all;
    }
};

StatisticRecord statistic_of(const Node& node) {
    StatisticRecord s;
    s.id = node.text("id"), s.what = node.text("what");
    s.value = node.number_or_null("value"), s.truth = node.number_or_null("truth");
    s.low = node.number_or_null("low"), s.high = node.number_or_null("high");
    s.delta0 = node.number_or_null("right_within").value_or(0);
    s.tolerance = node.number_or_null("wrong_beyond").value_or(0);
    s.exact = node.flag("exact"), s.replicates = node.count("replicates");
    s.verdict = node.verdict(), s.hint = node.text_or_none("hint");
    s.chi_squared = node.json.contains("chi_squared") && node.flag("chi_squared");
    return s;
}

std::optional<PictureCost> cost_of(const Node& node, const char* key) {
    if (!node.json.contains(key)) return std::nullopt;
    const Node cost = node.object(key);
    return PictureCost{cost.number_or_null("mse").value_or(0), cost.number("cpu_seconds")};
}

Trouble trouble_of(const Node& node) {
    return node.json.contains("trouble") ? Trouble(node.one_of(trouble_names, "trouble")) : Trouble::none;
}

CheckRecord check_of(const Node& node, const std::string& fragment) {
    CheckRecord c;
    c.name = node.text("name"), c.fragment = fragment;
    c.points = node.amount("points"), c.max_points = node.amount("max_points");
    c.verdict = node.verdict(), c.message = node.text_or_none("message");
    c.trouble = trouble_of(node);
    c.cpu_seconds = node.number("cpu_seconds");
    c.scene = node.text_or_none("scene");
    if (!c.scene.empty()) c.samples = node.count("samples"), c.sampler = node.text("sampler");
    c.cost = cost_of(node, "picture"), c.solution_cost = cost_of(node, "solution_picture");
    for (const Node& statistic : node.objects("statistics")) c.statistics.push_back(statistic_of(statistic));
    return c;
}

FragmentRecord fragment_of(const Node& node) {
    FragmentRecord f;
    f.name = node.text("name"), f.part = node.text("part");
    f.points = node.amount("points"), f.max_points = node.amount("max_points");
    if (node.json.contains("visibility")) f.visibility = node.text("visibility");
    f.verdict = node.verdict(), f.finished = node.flag("finished");
    f.trouble = trouble_of(node);
    f.file = node.text_or_none("file"), f.sha256 = node.text_or_none("sha256");
    f.cpu_seconds = node.number("cpu_seconds");
    if (node.json.contains("finding")) {
        const Node finding = node.object("finding");
        f.finding = {.how = finding.text_or_none("how"),
                     .where = finding.text_or_none("where"),
                     .arguments = finding.text_or_none("arguments"),
                     .answer = finding.text_or_none("answer"),
                     .right = finding.text_or_none("right"),
                     .sampled = finding.flag("sampled"),
                     .code = finding.text_or_none("code"),
                     .command = finding.text_or_none("command"),
                     .fault = finding.text_or_none("fault")};
    }
    f.warnings = node.text_or_none("warnings");
    for (const Node& check : node.objects("checks")) f.checks.push_back(check_of(check, f.name));
    const bool was_built = f.verdict != Verdict::did_not_build && f.verdict != Verdict::not_started;
    (was_built ? f.said : f.message) = node.text("message");
    return f;
}

Provenance provenance_of(const Node& node) {
    Provenance p;
    p.version = node.text("version"), p.commit = node.text("commit");
    p.program = node.text("program_sha256"), p.reference = node.text("reference_sha256");
    p.checks = node.text("checks_sha256"), p.toolchain = node.text("toolchain"), p.flags = node.texts("flags");
    p.built_for = node.text("built_for"), p.processor = node.text("processor");
    return p;
}

void require_schema(const Json& json, const std::string& path) {
    const std::string schema =
        json.is_object() && json.contains("schema") && json["schema"].is_string() ? json["schema"] : "";
    if (schema == record_schema) return;
    if (schema == "penumbra/result/v1")
        throw rt::InputError(
            fmt::format("{}: a record of an older grader, {}, which lacks what it was made of; expected "
                        "{}: grade the submission again",
                        path, schema, record_schema));
    throw rt::InputError(
        fmt::format("{}: is no record of a grading; expected {}, as grade --json FILE writes it", path, record_schema));
}

}  // namespace

Record record_of(const std::string& text, const std::string& path) {
    const Json json = Json::parse(text, nullptr, false);
    require_schema(json, path);
    const Node top{json, path, ""};
    Record record;
    record.date = top.text("date"), record.command = top.text("command");
    const Node submission = top.object("submission"), assignment = top.object("assignment");
    record.submission = submission.text("name"), record.sha256 = submission.text("sha256");
    record.notes = submission.texts("notes");
    if (submission.json.contains("student")) {
        const Node student = submission.object("student");
        record.student = student.text("name"), record.student_id = student.text("id");
    }
    record.title = assignment.text("title");
    for (const Node& part : assignment.objects("parts"))
        record.parts.push_back({part.text("name"), part.text("title")});
    const Node grader = top.object("grader");
    record.provenance = provenance_of(grader);
    record.provenance.assignment = assignment.text("sha256");
    record.sandbox = grader.text("sandbox");
    record.seed = top.at("seed", &Json::is_number_unsigned, "a number of at least 0");
    record.selection = top.texts("selection");
    const Node limits = top.object("limits");
    record.limits = {limits.number("time_limit"), limits.count("replicates"), limits.count("statistics")};
    for (const Node& fragment : top.objects("fragments")) record.fragments.push_back(fragment_of(fragment));
    record.wall_seconds = top.number("wall_seconds");
    return record;
}

Record read_record(const std::filesystem::path& path) {
    const auto text = read_text(path, most_record_bytes);
    if (!text) throw rt::InputError(fmt::format("{}: cannot be read; expected the record of a grading", path.string()));
    return record_of(*text, path.string());
}

}  // namespace grade
