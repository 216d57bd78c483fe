#pragma once

#include <string>
#include <vector>

#include "diagnosis/calls/arguments.h"
#include "rt/math.h"

/// Numbers and vectors in rows of arguments.
namespace grade {

inline rt::vec3 vector_at(const Row& row, std::size_t at) { return {row[at], row[at + 1], row[at + 2]}; }
inline void put(Row& row, std::size_t at, rt::vec3 v) { row[at] = v.x, row[at + 1] = v.y, row[at + 2] = v.z; }

/// A number of an argument: "camera.focus", "u.x".
struct Scalar {
    std::string name;
    std::size_t part, component;
    bool whole;

    std::size_t at(const Layout& layout) const { return layout.parts[part].at + component; }
    std::string owner() const { return name.substr(0, name.rfind('.')); }
};

/// Those of the parts that matter.
std::vector<Scalar> scalars_of(const Layout& layout, const std::vector<bool>& told);

}  // namespace grade
