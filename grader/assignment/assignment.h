#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace grade {

/// When students see a result in a course's system. Gradescope's words: where one test is hidden, it hides the total
/// too.
constexpr std::array<std::string_view, 4> visibilities = {"visible", "after_due_date", "after_published", "hidden"};

/// Of one fragment.
constexpr double most_points = 1000;

struct Part {
    std::string name, title;
};

struct Fragment {
    std::string name, part;
    double points = 0;                   // 0 where it is given
    bool given = false;                  // handed out filled in
    std::string visibility = "visible";  // of its result, to students; one of visibilities
};

/// The list of assignment.toml. A fragment that fragments.h declares and this list leaves out is handed out filled in,
/// as one that is given, and appears nowhere else.
struct Assignment {
    std::string title;
    std::vector<Part> parts;
    std::vector<Fragment> fragments;      // in the order of the parts
    std::optional<double> theory_points;  // none: the course has no theory part

    /// Its place in the list. Throws std::out_of_range for a name that is none.
    std::size_t place(const std::string& fragment) const;
    std::vector<std::string> names() const;

    /// What students fill in: those that are not given.
    std::set<std::string> asked() const;
};

/// The fragments of solution/, by name; none where there is no such folder.
std::vector<std::string> fragments_in(const std::string& folder);

/// Throws rt::InputError; for a fragment that is none of those, too, unless they are empty.
Assignment read_assignment(const std::string& path, const std::vector<std::string>& known = {});

}  // namespace grade
