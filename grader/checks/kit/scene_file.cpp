#include <fmt/format.h>

#include <algorithm>

#include "checks/kit/scene.h"
#include "files/words.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace grade {

namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; }

/// The name in "{name}" at the beginning of a text; empty: another brace, as of a table.
std::string_view placeholder(std::string_view text) {
    std::size_t end = 1;
    while (end < text.size() && is_letter(text[end])) ++end;
    return end < text.size() && text[end] == '}' ? text.substr(1, end - 1) : std::string_view();
}

[[noreturn]] void fail(std::string_view text, std::size_t at, const std::string& path, const std::string& message) {
    throw rt::InputError(fmt::format("{}:{}: {}", path, line_and_column(text, at), message));
}

std::vector<std::string> names_of(const SceneKeys& values) {
    std::vector<std::string> names;
    for (const SceneKey& key : values) names.emplace_back(key.name);
    return names;
}

}  // namespace

std::string filled_in(std::string_view text, const std::string& path, const SceneKeys& values) {
    std::string filled;
    std::vector<std::string> unused = names_of(values);
    for (std::size_t at = 0; at < text.size(); ++at) {
        const std::string_view name = text[at] == '{' ? placeholder(text.substr(at)) : std::string_view();
        if (name.empty()) {
            filled += text[at];
            continue;
        }
        const auto value = std::ranges::find(values, name, &SceneKey::name);
        if (value == values.end()) {
            const auto nearest = rt::nearest_word(name, names_of(values));
            fail(text, at, path,
                 fmt::format("the check gives no value for {{{}}}; expected {}", name,
                             nearest ? "{" + *nearest + "}?" : fmt::format("{{\"{}\", ...}} in its scene_from", name)));
        }
        filled += value->value.text;
        std::erase(unused, name);
        at += name.size() + 1;
    }
    if (!unused.empty())
        fail(text, text.size(), path,
             fmt::format("the check gives a value for {0}, which stands nowhere; expected {{{0}}} in this file",
                         unused.front()));
    return filled;
}

std::string scene_from(const std::string& file, const SceneKeys& values) {
    const std::string path = "grader/checks/" + file;
    std::vector<std::string> names;
    for (const auto& [name, text] : scene_texts()) {
        names.emplace_back(name);
        if (name != file) continue;
        std::string scene = filled_in(text, path, values);
        rt::parse_scene(scene, path);  // says what is wrong with it, where it stands
        return scene;
    }
    const auto nearest = rt::nearest_word(file, names);
    throw rt::InputError(fmt::format("{}:1:1: there is no such file; expected {}", path,
                                     nearest ? *nearest + "?" : "the scene that a check asks for"));
}

}  // namespace grade
