#pragma once

#include <algorithm>
#include <cctype>
#include <map>

#include "assignment/assignment.h"
#include "assignment/strip.h"
#include "files/files.h"

namespace grade {

/// By line that a student must write, without indentation: its file. All that say something, so neither brackets alone
/// nor comments.
inline std::map<std::string, std::string> secrets() {
    std::map<std::string, std::string> origin;
    for (const Fragment& fragment : read_assignment("assignment.toml").fragments) {
        const std::string path = "solution/" + fragment.name + ".cpp";
        if (fragment.given) continue;
        for (const std::string& line : find_region(read_text(path).value(), path).region) {
            const std::string text = line.substr(std::min(line.size(), line.find_first_not_of(" \t")));
            const bool speaks = std::ranges::any_of(text, [](unsigned char c) { return std::isalnum(c) != 0; });
            if (speaks && text != "} else {" && !text.starts_with("//")) origin[text] = path;
        }
    }
    return origin;
}

}  // namespace grade
