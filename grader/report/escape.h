#pragma once

#include <string>
#include <string_view>

namespace grade {

/// Text of a submission as it may be shown on a terminal: no control characters but line ends, no bytes that are no
/// UTF-8, at most that many bytes.
std::string printable(std::string_view text, std::size_t most = 2000);

/// The same of a name or a path, which stays on its line: also no line ends and no tabs.
std::string printable_line(std::string_view text, std::size_t most = 2000);

/// Text as it may stand in a page or in a quoted attribute; made printable first.
std::string html(std::string_view text);

/// The same, with what stands between backquotes as code, and elsewhere powers raised: "pixel^2".
std::string html_with_code(std::string_view text);

/// Text that is safe already, with powers raised by these tags: "pixel^2", "N^-1.5", and the unit "[m2]".
std::string with_powers(std::string_view safe, std::string_view open = "<sup>", std::string_view close = "</sup>");

}  // namespace grade
