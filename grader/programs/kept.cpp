#include "programs/kept.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "programs/kept_file.h"

namespace grade {

namespace {

constexpr std::uint64_t most = std::uint64_t(1) << 30;  // bytes of a file

/// All files below a folder with one of these ends, in an order of their own.
void add_files(Stamp& stamp, const fs::path& folder, const std::vector<std::string>& ends) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && std::ranges::count(ends, entry.path().extension().string()) > 0)
            files.push_back(entry.path());
    stamp.add_files(folder, std::move(files));
}

/// The grader, the framework, how it is compiled and linked, and what checks read.
Stamp stamp_of_framework(const Toolchain& chain) {
    Stamp stamp;
    const auto add_text = [&](const fs::path& file) { stamp.add(read_text(file, most).value_or("")); };
    add_text(fs::read_symlink("/proc/self/exe"));
    for (const fs::path& archive : chain.archives) add_text(archive);
    stamp.add(fmt::format("{} {} {} {}", chain.description, fmt::join(chain.compile, " "), fmt::join(chain.link, " "),
                          fmt::join(chain.libraries, " ")));
    for (const auto& [name, object] : chain.solution_objects) add_text(object);
    add_files(stamp, chain.blanks, {".cpp"});
    add_files(stamp, chain.source / "starter/rt", {".h"});
    add_files(stamp, chain.source / "scenes", {".obj", ".toml"});
    return stamp;
}

using Json = KeptJson;

Json to_json(const std::optional<double>& x) { return x ? Json(*x) : Json(); }
std::optional<double> number(const Json& x) { return x.is_null() ? std::nullopt : std::optional(x.get<double>()); }

Json to_json(const StatisticRecord& s) {
    return {{"id", s.id},
            {"what", s.what},
            {"value", to_json(s.value)},
            {"truth", to_json(s.truth)},
            {"low", to_json(s.low)},
            {"high", to_json(s.high)},
            {"delta0", s.delta0},
            {"tolerance", s.tolerance},
            {"exact", s.exact},
            {"replicates", s.replicates},
            {"verdict", int(s.verdict)},
            {"hint", s.hint},
            {"worth", int(s.worth)},
            {"without_numbers", s.without_numbers}};
}

StatisticRecord statistic(const Json& j) {
    return {j.at("id"),
            j.at("what"),
            number(j.at("value")),
            number(j.at("truth")),
            number(j.at("low")),
            number(j.at("high")),
            j.at("delta0"),
            j.at("tolerance"),
            j.at("exact"),
            j.at("replicates"),
            Verdict(j.at("verdict").get<int>()),
            j.at("hint"),
            StatisticRecord::Worth(j.at("worth").get<int>()),
            j.at("without_numbers")};
}

Json to_json(const CheckRecord& c) {
    Json statistics = Json::array();
    for (const StatisticRecord& s : c.statistics) statistics.push_back(to_json(s));
    // what a program prints may be any bytes
    const std::vector<std::uint8_t> excerpt(c.excerpt.begin(), c.excerpt.end());
    return {{"name", c.name},
            {"fragment", c.fragment},
            {"scene", c.scene},
            {"samples", c.samples},
            {"sampler", c.sampler},
            {"share", c.share},
            {"verdict", int(c.verdict)},
            {"message", c.message},
            {"trouble", int(c.trouble)},
            {"excerpt", Json::binary(excerpt)},
            {"statistics", statistics},
            {"cpu_seconds", c.cpu_seconds},
            {"tiles",
             {{"columns", c.tiles.columns},
              {"rows", c.tiles.rows},
              {"mine", c.tiles.mine},
              {"right", c.tiles.right},
              {"t", c.tiles.t},
              {"p", c.tiles.p}}},
            {"parting", c.parting},
            {"picture", kept_image(c.picture)},
            {"solution_picture", kept_image(c.solution_picture)}};
}

CheckRecord check_record(const Json& j) {
    CheckRecord c;
    c.name = j.at("name"), c.fragment = j.at("fragment"), c.scene = j.at("scene"), c.samples = j.at("samples");
    c.sampler = j.at("sampler"), c.share = j.at("share"), c.verdict = Verdict(j.at("verdict").get<int>());
    c.message = j.at("message"), c.cpu_seconds = j.at("cpu_seconds");
    c.trouble = Trouble(j.at("trouble").get<int>());
    const auto& excerpt = j.at("excerpt").get_binary();
    c.excerpt.assign(excerpt.begin(), excerpt.end());
    for (const Json& s : j.at("statistics")) c.statistics.push_back(statistic(s));
    const Json& tiles = j.at("tiles");
    c.tiles = {tiles.at("columns"), tiles.at("rows"), tiles.at("mine"),
               tiles.at("right"),   tiles.at("t"),    tiles.at("p")};
    c.parting = j.at("parting");
    c.picture = image_of(j.at("picture")), c.solution_picture = image_of(j.at("solution_picture"));
    return c;
}

Finding finding_record(const Json& j) {
    return {j.at("how"),     j.at("where"), j.at("arguments"), j.at("answer"), j.at("right"),
            j.at("sampled"), j.at("code"),  j.at("command"),   j.at("fault")};
}

bool stays(Verdict verdict) {
    return verdict == Verdict::passed || verdict == Verdict::failed || verdict == Verdict::not_finite ||
           verdict == Verdict::inconclusive;
}

}  // namespace

Kept::Kept(const fs::path& folder, const Toolchain& chain) : folder_(folder), framework_(stamp_of_framework(chain)) {
    fs::create_directories(folder);
}

fs::path Kept::path(const std::string& name, const std::string& made_from) const {
    return folder_ / (name + "." + Stamp(framework_).add(made_from).text());
}

std::optional<fs::path> Kept::object(const std::string& fragment, const std::string& text) const {
    if (folder_.empty()) return std::nullopt;
    const fs::path object = path(fragment + ".o", text);
    return fs::exists(object) ? std::optional(object) : std::nullopt;
}

namespace {

/// What was kept under this name is of no use any more.
void forget(const fs::path& folder, const std::string& name) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().stem() == name) fs::remove(entry.path());
}

}  // namespace

std::string Kept::warnings(const std::string& fragment, const std::string& text) const {
    return folder_.empty() ? "" : read_text(path(fragment + ".warnings", text)).value_or("");
}

void Kept::keep_object(const std::string& fragment, const std::string& text, const fs::path& object,
                       const std::string& warnings) const {
    if (folder_.empty()) return;
    for (const char* kind : {".o", ".warnings"}) forget(folder_, fragment + kind);
    write_text(path(fragment + ".warnings", text), warnings);
    if (const auto bytes = read_text(object)) write_text(path(fragment + ".o", text), *bytes);
}

void Kept::write(const std::string& name, const std::string& made_from, const nlohmann::ordered_json& json) const {
    if (folder_.empty()) return;
    forget(folder_, name);
    write_kept(path(name, made_from), json);
}

template <class Value>
std::optional<Value> Kept::read(const std::string& name, const std::string& made_from,
                                Value (*from)(const nlohmann::ordered_json&)) const {
    return folder_.empty() ? std::nullopt : read_kept(path(name, made_from), from);
}

std::optional<CheckRecord> Kept::check(const std::string& key, const std::string& made_from) const {
    return read<CheckRecord>(key, made_from, check_record);
}

void Kept::keep_check(const std::string& key, const std::string& made_from, const CheckRecord& record) const {
    if (stays(record.verdict)) write(key, made_from, to_json(record));
}

std::optional<Finding> Kept::finding(const std::string& key, const std::string& made_from) const {
    return read<Finding>(key, made_from, finding_record);
}

void Kept::keep_finding(const std::string& key, const std::string& made_from, const Finding& f) const {
    write(key, made_from,
          Json{{"how", f.how},
               {"where", f.where},
               {"arguments", f.arguments},
               {"answer", f.answer},
               {"right", f.right},
               {"sampled", f.sampled},
               {"code", f.code},
               {"command", f.command},
               {"fault", f.fault}});
}

std::optional<rt::Image> Kept::picture(const std::string& name, const std::string& made_from) const {
    return read<rt::Image>(name, made_from, image_of);
}

void Kept::keep_picture(const std::string& name, const std::string& made_from, const rt::Image& picture) const {
    write(name, made_from, kept_image(picture));
}

}  // namespace grade
