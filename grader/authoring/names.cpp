#include "authoring/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <regex>

#include "files/files.h"
#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"
#include "studies/studies.h"

namespace grade::authoring {

namespace {

constexpr std::array keywords = std::to_array<std::string_view>(
    {"alignas",     "alignof",  "and",        "and_eq",    "asm",       "auto",         "bitand",
     "bitor",       "bool",     "break",      "case",      "catch",     "char",         "char16_t",
     "char32_t",    "char8_t",  "class",      "co_await",  "co_return", "co_yield",     "compl",
     "concept",     "const",    "const_cast", "consteval", "constexpr", "constinit",    "continue",
     "decltype",    "default",  "delete",     "do",        "double",    "dynamic_cast", "else",
     "enum",        "explicit", "export",     "extern",    "false",     "float",        "for",
     "friend",      "goto",     "if",         "inline",    "int",       "long",         "mutable",
     "namespace",   "new",      "noexcept",   "not",       "not_eq",    "nullptr",      "operator",
     "or",          "or_eq",    "private",    "protected", "public",    "register",     "reinterpret_cast",
     "requires",    "return",   "short",      "signed",    "sizeof",    "static",       "static_assert",
     "static_cast", "struct",   "switch",     "template",  "this",      "thread_local", "throw",
     "true",        "try",      "typedef",    "typeid",    "typename",  "union",        "unsigned",
     "using",       "virtual",  "void",       "volatile",  "wchar_t",   "while",        "xor",
     "xor_eq",      "main",     "std",        "glm",       "rt"});

/// The first word of a call of the grader that is not in studies.h, and the folders that one grades.
constexpr std::array commands =
    std::to_array<std::string_view>({"picture", "call", "theory", "describe", "solution", "starter"});

/// The first header of the framework that declares such a name or calls it; empty: none does.
std::string header_with(const std::filesystem::path& project, const std::string& name) {
    const std::regex declared(fmt::format("\\b{0}\\(|::{0};|\\b(using|struct|enum|class|namespace) {0}\\b", name));
    std::vector<fs::path> headers;
    for (const auto& entry : fs::recursive_directory_iterator(project / "starter/rt"))
        if (entry.path().extension() == ".h") headers.push_back(entry.path().lexically_relative(project));
    std::ranges::sort(headers);
    for (const fs::path& header : headers)
        if (std::regex_search(read_text(project / header).value_or(""), declared)) return header.string();
    return {};
}

}  // namespace

void require_name(const std::string& name) {
    static const std::regex word("[a-z][a-z0-9_]*");
    if (!std::regex_match(name, word))
        throw rt::InputError(
            fmt::format("{}: is no name; expected small letters, digits and _, as in hit_sphere", rt::in_quotes(name)));
}

void require_free_name(const std::filesystem::path& project, const std::string& name) {
    const auto taken = [&](const std::string& by) {
        throw rt::InputError(fmt::format("{}: {}; expected another name", name, by));
    };
    if (name == "reflect" || name == "refract")
        taken("glm has a function of this name, which would be called in its place");
    if (std::ranges::count(keywords, name) > 0) taken("is a word of C++");
    if (std::ranges::count(commands, name) > 0 || std::ranges::count(studies, name, &Study::name) > 0)
        taken(fmt::format("./grade {} means something else", name));
    if (const std::string header = header_with(project, name); !header.empty())
        taken(header + " has this name already");
}

}  // namespace grade::authoring
