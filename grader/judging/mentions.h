#pragma once

#include <functional>
#include <set>
#include <string>

namespace grade {

/// These fragments, and those that their sources name, and those that these name...: all that can take part when they are called.
/// A name in a comment counts as well.
///
/// fragments  all names that there are
/// source     the text of a fragment; empty where there is none
std::set<std::string> with_mentioned(std::set<std::string> names, const std::set<std::string>& fragments,
                                     const std::function<std::string(const std::string&)>& source);

}  // namespace grade
