#include "convert/student.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace grade {

namespace {

using View = std::string_view;

bool is_number(View text) {
    return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::vector<View> split(View text, char at) {
    std::vector<View> words;
    for (std::size_t from = 0;;) {
        const std::size_t end = text.find(at, from);
        words.push_back(text.substr(from, end - from));
        if (end == text.npos) return words;
        from = end + 1;
    }
}

/// From that word on.
View rest(const std::vector<View>& words, std::size_t from) {
    if (from >= words.size()) return {};
    return {words[from].data(), std::size_t(words.back().data() + words.back().size() - words[from].data())};
}

bool read_canvas(View name, Student& student) {
    const std::vector<View> words = split(name, '_');
    if (words.size() < 4) return false;
    const std::size_t late = words[1] == "LATE" || words[1] == "late" ? 1 : 0;
    if (words.size() < 4 + late || !is_number(words[1 + late]) || !is_number(words[2 + late])) return false;
    student.name = words[0], student.id = words[1 + late], student.file = rest(words, 3 + late);
    student.system = "Canvas", student.is_late = late == 1, student.upload = words[2 + late];
    return true;
}

bool read_moodle(View name, Student& student) {
    const std::size_t marker = name.find("_assignsubmission_");
    if (marker == name.npos) return false;
    const std::size_t number = name.rfind('_', marker - 1);
    if (number == name.npos || !is_number(name.substr(number + 1, marker - number - 1))) return false;
    student.name = name.substr(0, number), student.id = name.substr(number + 1, marker - number - 1);
    View file = name.substr(marker + 18);  // "file_work.zip"
    file.remove_prefix(std::min(file.find('_'), file.size() - 1) + 1);
    student.file = file, student.system = "Moodle";
    return true;
}

bool read_blackboard(View name, Student& student) {
    const std::size_t marker = name.find("_attempt_");
    if (marker == name.npos) return false;
    const std::size_t user = name.rfind('_', marker - 1), begin = user == name.npos ? 0 : user + 1;
    constexpr std::size_t length = 19;  // 2026-01-31-12-00-00
    const View time = name.substr(marker + 9, length);
    if (time.size() != length || std::ranges::count(time, '-') != 5 || begin == marker) return false;
    student.name = student.id = name.substr(begin, marker - begin);
    View file = name.substr(marker + 9 + length);
    if (file.starts_with('_')) file.remove_prefix(1);
    student.file = file, student.attempt = time, student.system = "Blackboard";
    return true;
}

}  // namespace

std::string without_ending(std::string_view name) {
    for (const View ending : {".tar.gz", ".tgz", ".zip", ".tar"})
        if (name.size() > ending.size() && name.ends_with(ending))
            return std::string(name.substr(0, name.size() - ending.size()));
    return std::string(name);
}

Student student_of(std::string_view name) {
    Student student;
    if (read_moodle(name, student) || read_blackboard(name, student) || read_canvas(name, student)) return student;
    student.name = without_ending(name), student.file = name;
    // "alice (1).zip" beside "alice.zip"
    if (copy_of(name) > 0 && student.name.ends_with(')')) student.name.resize(student.name.rfind(" ("));
    if (name.starts_with("submission_") && is_number(name.substr(11)))
        student.id = name.substr(11), student.system = "Gradescope";
    return student;
}

int copy_of(std::string_view file) {
    std::string stem = without_ending(file);
    if (stem.ends_with(".cpp")) stem.resize(stem.size() - 4);
    std::size_t end = stem.size();
    const bool bracket = stem.ends_with(')');
    if (bracket) --end;
    std::size_t begin = end;
    while (begin > 0 && std::isdigit(static_cast<unsigned char>(stem[begin - 1]))) --begin;
    if (begin == end || end - begin > 3 || begin == 0 || stem[begin - 1] != (bracket ? '(' : '-')) return 0;
    return std::stoi(stem.substr(begin, end - begin));
}

}  // namespace grade
