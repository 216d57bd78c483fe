#pragma once

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

/// Nobody needs this file for the assignment.
namespace rt {

/// The number with which the text starts, by std::from_chars. libc++ has that for other than whole numbers from version
/// 20 on; before, by std::strtod, without what it takes beyond that: signs of plus, spaces, hexadecimal numbers.
template <class Number>
std::from_chars_result read_number(std::string_view text, Number& number) {
#ifndef __cpp_lib_to_chars
    if constexpr (std::is_floating_point_v<Number>) {
        const std::string word(text.substr(0, text.find_first_of("xX")));
        char* end = nullptr;
        errno = 0;
        if (word.find_first_of("+ \t\r\n\v\f") != 0) number = Number(std::strtod(word.c_str(), &end));
        if (!end || end == word.c_str()) return {text.data(), std::errc::invalid_argument};
        const bool beyond = errno == ERANGE && (number == 0 || number > 1 || number < -1);
        return {text.data() + (end - word.c_str()), beyond ? std::errc::result_out_of_range : std::errc()};
    } else
#endif
        return std::from_chars(text.data(), text.data() + text.size(), number);
}

}  // namespace rt
