#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"

namespace grade {

std::vector<Check> all_checks(std::uint64_t seed) {
    std::vector<Check> all;
    for (const auto& [name, checks] : fragment_checks) {
        Generator random = stream(seed, name);
        for (Check& check : checks(random)) {
            check.fragment = name;
            if (auto* probe = std::get_if<Probe>(&check.experiment)) probe->fragment = name;
            all.push_back(std::move(check));
        }
    }
    return all;
}

}  // namespace grade
