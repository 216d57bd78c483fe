#include "diagnosis/sanitizer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <sstream>
#include <vector>

#include "diagnosis/source/edits_in_words.h"
#include "protocol/protocol.h"

namespace grade {

namespace {

struct Known {
    const char* said;   // begins with
    const char* words;  // empty: what was said
};

constexpr Known runtime_errors[] = {
    {"execution reached the end of a value-returning function", "a way through this function ends without a return"},
    {"division by zero", "a whole number is divided by zero"},
    {"signed integer overflow", ""},
    {"index ", ""},
    {"shift exponent", ""},
    {"load of null pointer", "a null pointer is followed"},
    {"load of misaligned address", "a pointer leads to no number"},
    {"load of value", "a variable is read that has been given no value"},
    {"reference binding to null pointer", "a null pointer is followed"},
    {"member access within null pointer", "a null pointer is followed"},
    {"store to null pointer", "a null pointer is followed"},
    {"load of address", "an array is read beyond its end"},
    {"store to address", "an array is written beyond its end"}};

constexpr Known address_errors[] = {
    {"stack-overflow", "the function calls itself without end"},
    {"heap-buffer-overflow", "an array is read or written beyond its end"},
    {"stack-buffer-overflow", "an array is read or written beyond its end"},
    {"stack-buffer-underflow", "an array is read or written before its start"},
    {"dynamic-stack-buffer-overflow", "an array is read or written beyond its end"},
    {"global-buffer-overflow", "an array is read or written beyond its end"},
    {"container-overflow", "an array is read or written beyond its end"},
    {"heap-use-after-free", "memory is used that has been given back"},
    {"stack-use-after", "a variable is used that is gone: what it was declared in has ended"},
    {"allocation-size-too-big", "an array of too many elements is asked for"},
    {"FPE", "a whole number is divided by zero"},
    {"SEGV", "a pointer leads to memory that is not there"},
    {"BUS", "a pointer leads to memory that is not there"}};

template <std::size_t count>
std::optional<std::string> known(const Known (&list)[count], const std::string& said) {
    constexpr std::size_t longest = 120;
    for (const auto& [begin, words] : list)
        if (said.starts_with(begin)) return *words ? words : said.substr(0, longest);
    return std::nullopt;
}

/// Whether a function is in two of the calls that led there.
bool calls_itself(const std::string& said) {
    std::vector<std::string> functions;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t at = line.find(" in "); at != line.npos && line.find('#') < at)
            functions.push_back(line.substr(at, line.find('(') - at));
    std::ranges::sort(functions);
    return std::ranges::adjacent_find(functions) != functions.end();
}

/// What a program says that then ends itself: an assertion of the standard library, an exception, an exit.
std::optional<std::string> known_end(const std::string& line) {
    if (line.starts_with(exception_at_end))
        return "an exception is thrown: " + printable(line.substr(std::strlen(exception_at_end)));
    if (line + "\n" == exit_at_end) return "the program is ended here: a fragment must return, not exit";
    const std::size_t at = line.find("Assertion '");
    if (at == line.npos || !line.ends_with("failed.")) return std::nullopt;
    const std::string condition = line.substr(at);
    if (condition.find("< this->size()'") != condition.npos || condition.find("< size()'") != condition.npos)
        return "an index is out of range";
    if (condition.find("empty()'") != condition.npos) return "an element is taken of a list that has none";
    return std::nullopt;
}

}  // namespace

int line_in(const std::string& text, const std::string& file) {
    for (const std::string& before : {"/" + file + ":", file + ":"}) {
        const std::size_t at = text.find(before);
        if (at == text.npos) continue;
        int number = 0;
        for (std::size_t i = at + before.size();
             i < text.size() && text[i] >= '0' && text[i] <= '9' && number < 100'000; ++i)
            number = 10 * number + (text[i] - '0');
        if (number > 0) return number;
    }
    return 0;
}

std::string fault_in_words(const std::string& said, const std::string& fragment) {
    const std::string file = fragment + ".cpp";
    constexpr std::string_view runtime = ": runtime error: ", address = "ERROR: AddressSanitizer: ";
    std::optional<std::string> words;
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);) {
        std::size_t at = 0;
        if (!words && (at = line.find(runtime)) != line.npos)
            words = known(runtime_errors, line.substr(at + runtime.size()));
        else if (!words && (at = line.find(address)) != line.npos)
            words = line.substr(at + address.size()).starts_with("stack-overflow") && !calls_itself(said)
                        ? "the stack is full: an array has too many elements"
                        : known(address_errors, line.substr(at + address.size()));
        else if (!words)
            words = known_end(line);
        if (!words) continue;
        // the place, or the first of the calls below it that is the fragment's own
        if (const int number = line_in(line, file)) return fmt::format("{}:{}: {}", file, number, *words);
    }
    return words ? fmt::format("{}: {}", file, *words) : "";
}

}  // namespace grade
