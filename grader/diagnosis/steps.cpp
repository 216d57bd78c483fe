#include "diagnosis/steps.h"

#include "diagnosis/steps_made.h"

namespace grade {

std::vector<Steps> steps_of(const std::string& fragment) {
    for (const auto& some : {steps_of_integrals, steps_of_rays, steps_of_light, steps_of_warps, steps_of_lamps,
                             steps_of_lobes, steps_of_distribution})
        if (auto all = some(fragment); !all.empty()) return all;
    return {};
}

}  // namespace grade
