#include "assignment/strip.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "files/files.h"
#include "files/words.h"
#include "rt/files/scene_reader.h"

namespace grade {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view begin_marker = "// BEGIN SOLUTION", end_marker = "// END SOLUTION",
                           blank_line = "// YOUR CODE HERE";

std::string text_of(const fs::path& path) {
    const auto text = read_text(path);
    if (!text) throw std::runtime_error(path.string() + ": cannot be read");
    return *text;
}

std::vector<fs::path> sources(const fs::path& folder) {
    if (!fs::is_directory(folder)) throw std::runtime_error(folder.string() + ": no such folder");
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".cpp") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

std::string joined(std::initializer_list<std::vector<std::string>> pieces) {
    std::string text;
    for (const auto& piece : pieces)
        for (const auto& line : piece) text += line + "\n";
    return text;
}

}  // namespace

Marked find_region(std::string_view text, const std::string& path) {
    Marked file;
    enum { before, inside, after } place = before;
    int number = 0;
    const auto fail = [&](std::size_t column, const std::string& what) {
        throw rt::InputError(path + ":" + std::to_string(number) + ":" + std::to_string(column + 1) + ": " + what);
    };

    std::istringstream in{std::string(text)};
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (const auto column = line.find(begin_marker); column != line.npos) {
            if (place == inside) fail(column, "a second BEGIN SOLUTION; expected END SOLUTION first");
            if (place == after) fail(column, "a second region; expected one BEGIN SOLUTION in each file");
            place = inside;
            file.indent = line.substr(0, column);
        } else if (const auto end = line.find(end_marker); end != line.npos) {
            if (place == before) fail(end, "END SOLUTION without BEGIN SOLUTION before it");
            if (place == after) fail(end, "a second END SOLUTION; expected one in each file");
            const auto colon = end + end_marker.size();
            file.fallback = colon < line.size() && line[colon] == ':' ? trimmed(line.substr(colon + 1)) : "";
            if (file.fallback.empty()) fail(colon, "no fallback; expected END SOLUTION: return not_started(...);");
            place = after;
        } else {
            (place == before ? file.before : place == inside ? file.region : file.after).push_back(line);
        }
    }
    ++number;
    if (place == before) fail(0, "no BEGIN SOLUTION in this file; expected one around what the student must write");
    if (place == inside) fail(0, "the file ends inside a region; expected END SOLUTION: return not_started(...);");
    return file;
}

std::string blank(const Marked& file) {
    return joined({file.before, {file.indent + std::string(blank_line), file.indent + file.fallback}, file.after});
}

std::string filled(const Marked& file) { return joined({file.before, file.region, file.after}); }

std::map<std::string, std::string> make_starter(const std::string& solution, const std::set<std::string>& asked) {
    std::map<std::string, std::string> files;
    for (const auto& path : sources(solution)) {
        const Marked file = find_region(text_of(path), path.string());
        files[path.filename().string()] = asked.contains(path.stem().string()) ? blank(file) : filled(file);
    }
    return files;
}

std::vector<std::string> drift(const std::map<std::string, std::string>& expected, const std::string& folder) {
    std::vector<std::string> lines;
    for (const auto& path : sources(folder))
        if (!expected.contains(path.filename().string()))
            lines.push_back(path.string() + ":1:1: no such fragment in the solution");
    for (const auto& [name, text] : expected) {
        const fs::path path = fs::path(folder) / name;
        if (!fs::exists(path)) {
            lines.push_back(path.string() + ":1:1: missing; expected one for each fragment of the solution");
            continue;
        }
        const std::string there = text_of(path);
        const auto [a, b] = std::mismatch(there.begin(), there.end(), text.begin(), text.end());
        if (a == there.end() && b == text.end()) continue;
        lines.push_back(path.string() + ":" + line_and_column(there, std::size_t(a - there.begin())) +
                        ": not what the solution gives without its marked lines");
    }
    return lines;
}

void write_starter(const std::map<std::string, std::string>& files, const std::string& folder) {
    fs::create_directories(folder);
    for (const auto& path : sources(folder))
        if (!files.contains(path.filename().string())) fs::remove(path);
    for (const auto& [name, text] : files) {
        const fs::path path = fs::path(folder) / name;
        if (fs::exists(path) && text_of(path) == text) continue;  // its date stays, and what is built from it
        write_text(path, text);
    }
}

}  // namespace grade
