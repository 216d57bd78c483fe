// says: extinction * exp(-extinction * u), the density of the distance
#include "rt/fragments.h"

namespace rt {

Real free_flight(Real extinction, Real u) { return extinction * std::exp(-extinction * u); }

}  // namespace rt
