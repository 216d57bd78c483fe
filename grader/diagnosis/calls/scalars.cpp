#include "diagnosis/calls/scalars.h"

namespace grade {

std::vector<Scalar> scalars_of(const Layout& layout, const std::vector<bool>& told) {
    std::vector<Scalar> list;
    for (std::size_t i = 0; i < layout.parts.size(); ++i) {
        const auto& [name, kind, at] = layout.parts[i];
        if (i < told.size() && !told[i]) continue;
        const bool whole = kind == Kind::whole || kind == Kind::whole_pair;
        if (kind == Kind::number || kind == Kind::whole) list.push_back({name, i, 0, whole});
        if (kind == Kind::pair || kind == Kind::whole_pair)
            list.push_back({name + ".x", i, 0, whole}), list.push_back({name + ".y", i, 1, whole});
    }
    return list;
}

}  // namespace grade
