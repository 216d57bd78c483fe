#include "rt/stages/stages.h"

namespace rt {

Color film_stage(const Color* radiance, const Real* weight, int n) {
    return pixel_mean({radiance, std::size_t(n)}, {weight, std::size_t(n)});
}

}  // namespace rt
