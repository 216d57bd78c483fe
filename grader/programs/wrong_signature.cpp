#include "programs/wrong_signature.h"

#include <fmt/format.h>

#include <cstring>
#include <sstream>
#include <utility>
#include <vector>

#include "programs/compile.h"

namespace grade {

namespace {

/// With the names that fragments.h has for types: "vec3" for "glm::vec<3, double, (glm::qualifier)0>".
std::string as_in_fragments(std::string name) {
    for (const auto& [text, short_text] : {std::pair("glm::vec<3, double, (glm::qualifier)0>", "vec3"),
                                           std::pair("glm::vec<2, double, (glm::qualifier)0>", "vec2")})
        for (std::size_t at; (at = name.find(text)) != name.npos;) name.replace(at, std::strlen(text), short_text);
    return name;
}

/// Names for people of symbols that a student may have made up.
std::vector<std::string> demangled(const Sandbox& sandbox, std::vector<std::string> symbols, const fs::path& work) {
    std::vector<std::string> command{"/usr/bin/c++filt"}, names;
    command.insert(command.end(), symbols.begin(), symbols.end());
    Step step{std::move(command), {}, work, {}};
    step.limits.cpu_seconds = step.limits.most_cpu_seconds = 2;
    step.limits.wall_seconds = 3 * most_compiler_seconds;
    step.limits.memory = 256u << 20;
    std::istringstream lines(run(sandbox, step).out);
    for (std::string line; std::getline(lines, line);) names.push_back(as_in_fragments(line).substr(0, 300));
    return names.size() == symbols.size() ? names : symbols;
}

}  // namespace

std::string wrong_signature(const Toolchain& chain, const Sandbox& sandbox, const ObjectFile& object,
                            const std::string& fragment, const std::string& shown, const fs::path& work) {
    constexpr std::size_t most_names = 16;
    std::vector<std::string> symbols{chain.symbols.at(fragment)};
    for (const std::string& symbol : object.defined)
        if (symbol.find(fragment) != symbol.npos && symbols.size() < most_names) symbols.push_back(symbol);
    const std::vector<std::string> names = demangled(sandbox, symbols, work);
    std::string found;
    for (std::size_t i = 1; i < names.size(); ++i)
        if (names[i].find(fragment + "(") != names[i].npos) found = names[i];
    if (found.empty())
        return fmt::format("{}: error: no function {} is defined here; fragments.h declares\n    {}\n", shown, fragment,
                           names[0]);
    return fmt::format("{}: error: the signature differs from fragments.h:\n    here         {}\n    fragments.h  {}\n",
                       shown, found, names[0]);
}

}  // namespace grade
