#pragma once

#include <optional>
#include <string>

namespace grade {

/// What a child with sanitizers said at the end of its time: which of the calls it was answering. Untrusted text.
std::optional<std::size_t> call_at_end_of(const std::string& said);

/// The loop that it was in then, of a fragment with that source: "phong.cpp:24: the loop here does not end". Empty:
/// nothing of the fragment's own is told.
///
/// is_endless  it was one call alone, which needs no time where it is right
std::string loop_in_words(const std::string& said, const std::string& fragment, const std::string& source,
                          bool is_endless);

}  // namespace grade
