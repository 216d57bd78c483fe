#pragma once

#include "checks/check.h"

namespace grade {

/// A check that calls its fragment; all.cpp fills in the fragment.
inline Check probe_check(std::string name, std::string fragment, std::vector<std::string> needs,
                         std::function<Rows(Generator&)> inputs, std::vector<Statistic> statistics, int share = 1) {
    return {std::move(name),       fragment, std::move(needs), Probe{fragment, std::move(inputs)},
            std::move(statistics), share};
}

/// So many rows.
template <class F>
std::function<Rows(Generator&)> rows_of(int count, F draw) {
    return [count, draw](Generator& random) {
        Rows rows;
        for (int k = 0; k < count; ++k) rows.push_back(draw(random));
        return rows;
    };
}

}  // namespace grade
