#include "child/probes.h"

#include <map>
#include <string>

#include "child/each_fragment.h"
#include "protocol/caller.h"

namespace grade {

namespace {

using Callers = std::map<std::string, Caller, std::less<>>;

const Callers& callers() {
    static const Callers all = [] {
        Callers list;
        each_fragment([&](const char* name, auto* fragment) { list.emplace(name, caller(fragment)); });
        return list;
    }();
    return all;
}

}  // namespace

std::vector<double> probe(std::string_view fragment, std::span<const double> row) {
    const auto found = callers().find(fragment);
    if (found == callers().end()) throw std::invalid_argument("no fragment is named " + std::string(fragment));
    return found->second(row);
}

}  // namespace grade
