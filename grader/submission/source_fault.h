#pragma once

#include <string>
#include <string_view>

namespace grade {

/// Why a file cannot be what its author meant, where a compiler would only say so in many words: text in UTF-16, a page
/// of a web site, a comment without an end, a merge that git has left to its author. A message like a compiler's;
/// empty: none of these.
///
/// shown  the file's path in messages
std::string source_fault(std::string_view text, const std::string& shown);

}  // namespace grade
