#pragma once

#include <optional>

#include "checks/kit/check.h"
#include "rt/scene.h"

/// Half a floor in the shadow of a half plane: penumbra, umbra, and the light of what is lit.
namespace grade {

/// The scene in a frame of its own: floor z = 0; light in the middle at z = light_height, facing down; blocker x < 0 at
/// z = blocker_height; and a lid above the light, which must not matter. No kind: a point light.
struct ShadowScene {
    std::optional<rt::Emitter::Kind> kind;
    double light_height = 2, blocker_height = 1;
    double half_width = 0.25,
           half_length = 0.3;           // of a quad across and along the blocker's edge; else half_width is the radius
    double albedo = 0.7, radiance = 5;  // a point light's intensity
    double specular = 0;
};
ShadowScene any_shadow(Generator& random, std::optional<rt::Emitter::Kind> kind);

/// Width of its penumbra on the floor [m].
double penumbra_of(const ShadowScene& scene);

/// Radiance of the floor at x, y: albedo/pi times the irradiance by the part of the light that is seen past the
/// blocker.
double floor_radiance(const ShadowScene& scene, double x, double y, bool blocked);

/// The check: umbra 0 (L4), lit floor (L1), width and place of the penumbra (L3).
Check shadow_check(Generator& random, const std::string& name, const ShadowScene& scene);

}  // namespace grade
