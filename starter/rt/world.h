#pragma once

#include <vector>

#include "rt/batch.h"
#include "rt/bvh.h"
#include "rt/plan.h"

namespace rt {

/// A shape with its number and its motion.
template <class Shape>
struct Numbered {
    Shape shape;
    Index id;
    vec3 velocity;
    Box box;  // about all of its motion
};

/// What the surface stage must know of a shape, found by its number.
struct SurfaceRecord {
    vec3 center{0};      // of a sphere; a point of a flat shape
    Real radius = 0;     // of a sphere; 0: flat
    vec3 normal{0};      // of a flat shape, unit, on its front side
    Real reach = 0;      // largest coordinate: what its rounding errors are measured by [world]
    vec3 velocity{0};
    Index material = 0;
    bool sampled = false;  // an emitter that shadow rays look for
    Index shines = 0;      // 1: its front side sends out light
    Index smooth = nothing;  // which of World::smooth has its normals
};

/// What the direct stage must know of a material.
struct Reflectance {
    Color albedo{0}, specular{0};
    Real shininess = 1;
    Index reflects = 0;  // 1: any light
};

/// A triangle with a normal at each corner.
struct SmoothTriangle {
    Triangle triangle;
    vec3 na, nb, nc;
};

/// A scene laid out for the stages' loops.
struct World {
    Scene scene;
    RenderPlan plan;
    std::vector<Numbered<Sphere>> spheres;
    std::vector<Numbered<Triangle>> triangles;
    std::vector<Numbered<Quad>> quads;
    std::vector<Numbered<Disc>> discs;
    std::vector<Emitter> emitters;
    std::vector<SurfaceRecord> surfaces;  // by number
    std::vector<SmoothTriangle> smooth;
    std::vector<Reflectance> reflectances;  // of no surface, which is black, and then of each material
    Bvh bvh;
};

World make_world(const Scene& scene);

}  // namespace rt
