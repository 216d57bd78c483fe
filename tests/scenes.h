#pragma once

#include "checks/kit/scene.h"

/// Scenes of tests, piece by piece, as those of checks.
using grade::disc, grade::environment, grade::material, grade::point_light, grade::quad, grade::scene_table,
    grade::sphere, grade::triangle, grade::unsampled_lamp;

inline std::string camera(rt::vec3 eye, rt::vec3 target, grade::SceneKeys more = {}) {
    more.insert(more.begin(), {{"eye", eye}, {"target", target}});
    return scene_table("[camera]", more);
}
