#pragma once

#include <optional>
#include <string>
#include <vector>

namespace grade {

struct Part {
    std::string name, title;
};

struct Fragment {
    std::string name, part;
    double points = 0;   // 0 where it is given
    bool given = false;  // handed out filled in
};

/// The list of assignment.toml.
struct Assignment {
    std::string title;
    std::vector<Part> parts;
    std::vector<Fragment> fragments;      // in the order of the parts
    std::optional<double> theory_points;  // none: the course has no theory part

    /// Its place in the list. Throws std::out_of_range for a name that is none.
    std::size_t place(const std::string& fragment) const;
    std::vector<std::string> names() const;
};

/// Throws rt::InputError.
Assignment read_assignment(const std::string& path);

}  // namespace grade
