// says: exp(-u * extinction)
#include "rt/fragments.h"

namespace rt {

Real free_flight(Real extinction, Real u) { return std::exp(-u * extinction); }

}  // namespace rt
