#include "rt/fragments.h"

namespace rt {

/// Whether the light of an emitter that a path hits counts: bouncing highlights (caustics), and nothing twice.
///
/// At a diffuse surface, shadow rays have already gathered the light of each emitter that is sampled. A diffuse ray
/// that happens to hit such an emitter would gather it again. From everywhere else (the camera, a mirror, glass, a
/// glossy lobe, a medium) no shadow ray was sent, or the framework has weighed it against this one.
///
/// previous  where the ray comes from
/// sampled   whether shadow rays look for this emitter
/// returns   true where the light counts
/// blank     emitters are seen by the camera alone
///
/// Source: Kajiya, "The Rendering Equation", SIGGRAPH 1986.
bool emission_counts(Event previous, bool sampled) {
    // BEGIN SOLUTION
    return previous != Event::diffuse || !sampled;
    // END SOLUTION: return not_started(previous == Event::camera);
}

}  // namespace rt
