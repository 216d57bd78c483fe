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

/// This type, or the same as a constant.
template <class Type, class Record>
concept Some = std::same_as<std::remove_const_t<Type>, Record>;

void each_field(Some<StatisticRecord> auto& s, auto&& field) {
    field("id", s.id), field("what", s.what), field("value", s.value), field("truth", s.truth), field("low", s.low);
    field("high", s.high), field("delta0", s.delta0), field("tolerance", s.tolerance), field("exact", s.exact);
    field("replicates", s.replicates), field("verdict", s.verdict), field("hint", s.hint), field("worth", s.worth);
    field("without_numbers", s.without_numbers), field("chi_squared", s.chi_squared);
}

void each_field(Some<Tiles> auto& t, auto&& field) {
    field("columns", t.columns), field("rows", t.rows), field("mine", t.mine), field("right", t.right);
    field("t", t.t), field("p", t.p);
}

/// But for points and costs, which are made anew.
void each_field(Some<CheckRecord> auto& c, auto&& field) {
    field("name", c.name), field("fragment", c.fragment), field("scene", c.scene), field("samples", c.samples);
    field("sampler", c.sampler), field("share", c.share), field("verdict", c.verdict), field("message", c.message);
    field("trouble", c.trouble), field("excerpt", c.excerpt), field("statistics", c.statistics);
    field("cpu_seconds", c.cpu_seconds), field("tiles", c.tiles), field("parting", c.parting);
    field("picture", c.picture), field("solution_picture", c.solution_picture);
}

void each_field(Some<Finding> auto& f, auto&& field) {
    field("how", f.how), field("where", f.where), field("arguments", f.arguments), field("answer", f.answer);
    field("right", f.right), field("sampled", f.sampled), field("code", f.code), field("command", f.command);
    field("fault", f.fault), field("of_numbers", f.of_numbers), field("line", f.line),
        field("says_which", f.says_which), field("by_textbook", f.by_textbook), field("of_nan", f.of_nan),
        field("has_name", f.has_name);
}

void each_field(Some<Drawn> auto& d, auto&& field) { field("image", d.image), field("fault", d.fault); }

template <class Type>
KeptJson json_of(const Type& x) {
    if constexpr (requires { each_field(x, [](const char*, const auto&) {}); }) {
        KeptJson json;
        each_field(x, [&](const char* name, const auto& field) { json[name] = json_of(field); });
        return json;
    } else if constexpr (std::is_same_v<Type, std::vector<StatisticRecord>>) {
        KeptJson all = KeptJson::array();
        for (const StatisticRecord& s : x) all.push_back(json_of(s));
        return all;
    } else if constexpr (std::is_same_v<Type, std::optional<double>>) {
        return x ? KeptJson(*x) : KeptJson();
    } else if constexpr (std::is_same_v<Type, rt::Image>) {
        return kept_image(x);
    } else {
        return x;
    }
}

template <class Type>
Type of_json(const KeptJson& json) {
    if constexpr (requires(Type x) { each_field(x, [](const char*, auto&) {}); }) {
        Type x;
        each_field(x, [&]<class Field>(const char* name, Field& field) { field = of_json<Field>(json.at(name)); });
        return x;
    } else if constexpr (std::is_same_v<Type, std::vector<StatisticRecord>>) {
        Type all;
        for (const KeptJson& s : json) all.push_back(of_json<StatisticRecord>(s));
        return all;
    } else if constexpr (std::is_same_v<Type, std::optional<double>>) {
        return json.is_null() ? std::nullopt : std::optional(json.get<double>());
    } else if constexpr (std::is_same_v<Type, rt::Image>) {
        return image_of(json);
    } else {
        return json.get<Type>();
    }
}

bool stays(Verdict verdict) {
    return verdict == Verdict::passed || verdict == Verdict::failed || verdict == Verdict::not_finite ||
           verdict == Verdict::inconclusive;
}

/// What was kept under this name is of no use any more.
void forget(const fs::path& folder, const std::string& name) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().stem() == name) fs::remove(entry.path());
}

}  // namespace

Kept::Kept(const fs::path& folder, const Toolchain& chain, bool finds)
    : folder_(folder), finds_(finds), framework_(stamp_of_framework(chain)) {
    fs::create_directories(folder);
}

fs::path Kept::path(const std::string& name, const std::string& made_from) const {
    return folder_ / (name + "." + Stamp(framework_).add(made_from).text());
}

std::optional<fs::path> Kept::object(const std::string& fragment, const std::string& text) const {
    if (!finds_) return std::nullopt;
    const fs::path object = path(fragment + ".o", text);
    return fs::exists(object) ? std::optional(object) : std::nullopt;
}

std::string Kept::warnings(const std::string& fragment, const std::string& text) const {
    return !finds_ ? "" : read_text(path(fragment + ".warnings", text)).value_or("");
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
    return !finds_ ? std::nullopt : read_kept(path(name, made_from), from);
}

std::optional<CheckRecord> Kept::check(const std::string& key, const std::string& made_from) const {
    return read<CheckRecord>(key, made_from, of_json);
}

void Kept::keep_check(const std::string& key, const std::string& made_from, const CheckRecord& record) const {
    if (stays(record.verdict)) write(key, made_from, json_of(record));
}

std::optional<Finding> Kept::finding(const std::string& key, const std::string& made_from) const {
    return read<Finding>(key, made_from, of_json);
}

void Kept::keep_finding(const std::string& key, const std::string& made_from, const Finding& f) const {
    write(key, made_from, json_of(f));
}

std::optional<Drawn> Kept::drawn(const std::string& name, const std::string& made_from) const {
    return read<Drawn>(name, made_from, of_json);
}

void Kept::keep_drawn(const std::string& name, const std::string& made_from, const Drawn& drawn) const {
    write(name, made_from, json_of(drawn));
}

}  // namespace grade
