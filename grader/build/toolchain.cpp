#include "build/toolchain.h"

#include <cxxabi.h>
#include <fmt/format.h>
#include <toml++/toml.h>

#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "build/process.h"
#include "build/refuse.h"

namespace grade {

namespace {

template <class Value = std::string>
std::vector<Value> list(const toml::table& file, const char* key) {
    std::vector<Value> values;
    if (const toml::array* array = file[key].as_array())
        for (const toml::node& node : *array) {
            std::string value = node.value_or(std::string());
            if (!value.empty() && value != "/usr/include") values.emplace_back(std::move(value));
        }
    return values;
}

/// By fragment: .../phong.cpp.o is phong's.
std::map<std::string, fs::path> by_fragment(const std::vector<fs::path>& objects) {
    std::map<std::string, fs::path> map;
    for (const fs::path& object : objects) {
        const std::string file = object.filename().string();
        map[file.substr(0, file.find('.'))] = object;
    }
    return map;
}

/// The fragments' names for the linker, from what the child needs: rt::phong(...) is phong's.
std::map<std::string, std::string> fragment_symbols(const fs::path& child) {
    std::map<std::string, std::string> map;
    for (const std::string& symbol : symbols_of(child, true)) {
        const std::string name = demangled(symbol);
        const std::size_t bracket = name.find('(');
        if (name.starts_with("rt::") && bracket != name.npos) map[name.substr(4, bracket - 4)] = symbol;
    }
    return map;
}

}  // namespace

Toolchain read_toolchain(const fs::path& path) try {
    const toml::table file = toml::parse_file(path.string());
    const auto text = [&](const char* key) { return file[key].value_or(std::string()); };

    Toolchain chain;
    chain.source = text("source");
    chain.compiler = text("compiler");
    chain.description = text("description");
    chain.compile = list(file, "compile");
    for (const std::string& option : list(file, "options")) chain.compile.push_back(option);
    chain.includes = list<fs::path>(file, "includes");
    chain.precompiled = text("precompiled");
    chain.link = list(file, "link");
    chain.archives = list<fs::path>(file, "archives");
    chain.libraries = list(file, "libraries");
    chain.blanks = text("blanks");
    chain.blank_objects = by_fragment(list<fs::path>(file, "blank_objects"));
    chain.solution_objects = by_fragment(list<fs::path>(file, "solution_objects"));
    for (const fs::path& archive : chain.archives)
        if (!fs::exists(archive)) throw std::runtime_error(fmt::format("{}: not built yet", archive.string()));
    if (chain.archives.empty()) throw std::runtime_error(fmt::format("{}: names no archives", path.string()));
    chain.symbols = fragment_symbols(chain.archives.front());
    refuse_other_arithmetic(chain);
    return chain;
} catch (const toml::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}: {}; expected the file that the build writes", path.string(), error.description()));
}

std::string demangled(const std::string& symbol) {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                      std::free);
    return status == 0 ? name.get() : symbol;
}

std::vector<std::string> symbols_of(const fs::path& object, bool undefined) {
    Limits limits;
    limits.output = 8u << 20;
    const Ending nm = run({"/usr/bin/nm", "--format=posix", undefined ? "--undefined-only" : "--defined-only",
                           "--extern-only", object.string()},
                          limits, "/");
    if (!nm.good()) throw std::runtime_error(fmt::format("{}: nm cannot read it: {}", object.string(), nm.err));
    std::vector<std::string> symbols;
    std::istringstream lines(nm.out);
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t space = line.find(' '); space != line.npos) symbols.push_back(line.substr(0, space));
    return symbols;
}

}  // namespace grade
