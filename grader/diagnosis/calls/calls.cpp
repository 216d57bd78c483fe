#include "diagnosis/calls/calls.h"

#include <set>

namespace grade {

bool Calls::is_wrong(std::size_t k) const { return !is_equal(result, mine[k], right[k]); }

std::vector<std::size_t> Calls::wrong() const {
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < size(); ++k)
        if (is_wrong(k)) all.push_back(k);
    return all;
}

std::vector<const Field*> Calls::wrong_parts() const {
    std::vector<const Field*> parts;
    for (const Field& part : result.parts)
        for (std::size_t k = 0; k < size(); ++k)
            if (counts(result, part, mine[k], right[k]) && !is_equal(part, mine[k], right[k])) {
                parts.push_back(&part);
                break;
            }
    return parts;
}

std::vector<bool> told_of(const Calls& calls, const std::vector<std::size_t>& scope) {
    const auto& parts = calls.layouts.front().parts;
    std::vector<bool> told = calls.told;
    told.resize(parts.size(), true);
    for (const Field& kind : parts) {
        if (kind.kind != Kind::choice || !kind.name.ends_with(".kind")) continue;
        std::set<double> kinds;
        for (const std::size_t k : scope) kinds.insert(calls.rows[k][kind.at]);
        for (double value = 0; value < 5; ++value) {
            if (kinds == std::set{value}) continue;
            const std::string name = value_in_words({kind.name, kind.kind, 0}, {value});
            const std::string member = kind.name.substr(0, kind.name.size() - 4) + name + ".";
            for (std::size_t i = 0; i < parts.size(); ++i) told[i] = told[i] && !parts[i].name.starts_with(member);
        }
    }
    return told;
}

}  // namespace grade
