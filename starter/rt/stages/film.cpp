#include "rt/fragments.h"
#include "rt/stages/stages.h"

namespace rt {

Color film_stage(const World& world, const Color* radiance, const Real* weight, int n) {
    if (!world.plan.pixel) return radiance[0];
    return pixel_mean({radiance, std::size_t(n)}, {weight, std::size_t(n)});
}

}  // namespace rt
