#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// The starter's fragments are the solution's without what the student must write. A solution file holds one region:
///
///     // BEGIN SOLUTION
///     return d - 2.0 * dot(d, n) * n;
///     // END SOLUTION: return not_started(d);
namespace grade {

/// A solution file in its three pieces.
struct Marked {
    std::vector<std::string> before, region, after;  // lines; the markers are in none of them
    std::string indent;                              // of the first marker
    std::string fallback;                            // what the last marker says
};

/// Finds the region. path is for errors: throws rt::InputError where a marker is missing, repeated or out of order.
Marked find_region(std::string_view text, const std::string& path);

/// The file as the student gets it: the region is replaced by `// YOUR CODE HERE` and the fallback.
std::string blank(const Marked& file);

/// The file with the region filled in, and no markers: a fragment that is given.
std::string filled(const Marked& file);

/// File name and text of each fragment of the starter, made from the .cpp files of a folder. Those named in `asked`
/// (without .cpp) are blank, the others filled in. Throws rt::InputError.
std::map<std::string, std::string> make_starter(const std::string& solution, const std::set<std::string>& asked);

/// How the .cpp files of a folder differ from what they should be, one line each; empty: not at all.
std::vector<std::string> drift(const std::map<std::string, std::string>& expected, const std::string& folder);

/// Writes the files that differ, and removes .cpp files that should not be there. Throws std::runtime_error.
void write_starter(const std::map<std::string, std::string>& files, const std::string& folder);

}  // namespace grade
