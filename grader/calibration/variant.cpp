#include "calibration/variant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <tuple>

#include "files/files.h"
#include "files/words.h"
#include "programs/process.h"
#include "rt/files/scene_reader.h"

namespace grade::calibration {

namespace {

constexpr std::pair<const char*, Variant::Kind> folders[] = {{"wrong", Variant::Kind::wrong},
                                                             {"right", Variant::Kind::right},
                                                             {"dose", Variant::Kind::dose},
                                                             {"confined", Variant::Kind::confined}};

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);)
        if (part = trimmed(part); !part.empty()) parts.push_back(part);
    return parts;
}

Variant read_variant(const fs::path& path, Variant::Kind kind) {
    Variant variant;
    variant.kind = kind;
    variant.name = (path.parent_path().filename() / path.stem()).string();
    variant.patch = read_text(path).value_or("");
    std::istringstream lines(variant.patch);
    int number = 0;
    for (std::string line; std::getline(lines, line) && line.starts_with("# ");) {
        ++number;
        const std::string text = line.substr(2);
        const auto colon = text.find(": ");
        const std::string key = text.substr(0, colon),
                          value = colon == text.npos ? "" : trimmed(text.substr(colon + 2));
        if (number == 1)
            variant.what = text;
        else if (key == "fragment")
            variant.fragment = value;
        else if (key == "says")
            variant.says = split(value, '|');
        else if (key == "scene")
            variant.scene = value;
        else if (key == "doses")
            variant.doses = split(value, ' ');
        else
            throw rt::InputError(fmt::format("{}:{}:3: unknown key {}; expected fragment, says, scene or doses",
                                             path.string(), number, key));
    }
    if (variant.fragment.empty())
        throw rt::InputError(fmt::format("{}:{}:1: no fragment is named; expected a line \"# fragment: NAME\"",
                                         path.string(), number + 1));
    return variant;
}

}  // namespace

std::vector<Variant> read_variants(const fs::path& folder) {
    std::vector<Variant> all;
    for (const auto& [name, kind] : folders) {
        if (!fs::is_directory(folder / name)) continue;
        for (const auto& entry : fs::directory_iterator(folder / name))
            if (entry.path().extension() == ".patch") all.push_back(read_variant(entry.path(), kind));
    }
    const auto number = [](const Variant& v) { return std::atoi(v.name.substr(v.name.find('/') + 1).c_str()); };
    std::ranges::sort(all, {}, [&](const Variant& v) { return std::tuple(v.kind, number(v), v.name); });
    return all;
}

std::string changed_text(const Variant& variant, const fs::path& source, const std::string& dose) {
    const TemporaryFolder work;
    const fs::path file = fs::path("solution") / (variant.fragment + ".cpp");
    const auto original = read_text(source / file);
    if (!original)
        throw rt::InputError(fmt::format("tests/variants/{}.patch:1:1: there is no {}", variant.name, file.string()));
    std::string patch = variant.patch;
    for (std::size_t at; (at = patch.find("DOSE")) != patch.npos;) patch.replace(at, 4, dose);
    fs::create_directories(work.path() / "solution");
    write_text(work.path() / file, *original);
    write_text(work.path() / "patch", patch);
    const Ending ending =
        run({"/usr/bin/patch", "-p1", "--silent", "--no-backup-if-mismatch", "-i", "patch"}, {}, work.path().string());
    if (!ending.good())
        throw rt::InputError(fmt::format("tests/variants/{}.patch:1:1: does not apply to {} any more: {}{}",
                                         variant.name, file.string(), ending.out, ending.err));
    return read_text(work.path() / file).value();
}

}  // namespace grade::calibration
