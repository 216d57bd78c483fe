#include "rt/fragments.h"

namespace rt {

bool emission_counts(Event previous, bool sampled) { return previous != Event::diffuse || !sampled; }

}  // namespace rt
