#pragma once

#include <vector>

#include "rt/scene.h"

/// What is seen, as far as a plan must know it. Nobody needs this file for the assignment.
namespace rt {

/// A point of a surface that is seen.
struct Point {
    vec3 place, normal, to_viewer;  // unit; the normal is on the viewer's side [world]
    const Material* material;
    const Shape* shape;  // none: a mesh
};

/// What the camera sees at the middles of side x side parts of the film; and where light bounces, what is seen from
/// there.
struct View {
    int side;
    std::vector<Point> points;
    std::vector<int> on_film;  // of each part of the film, row by row: its place among the points; -1: nothing is seen
};

/// Not by fragments: the plan must not depend on them.
View view_of(const Scene& scene, int side);

}  // namespace rt
