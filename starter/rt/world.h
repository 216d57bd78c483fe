#pragma once

#include <vector>

#include "rt/batch.h"
#include "rt/lamps/lamp_tree.h"
#include "rt/media/regions.h"
#include "rt/plan.h"
#include "rt/tree/bvh.h"

namespace rt {

/// What the surface stage must know of a shape, found by its number.
struct SurfaceRecord {
    vec3 center{0};   // of a sphere; a point of a flat shape
    Real radius = 0;  // of a sphere; 0: flat
    vec3 normal{0};   // of a flat shape, unit, on its front side
    Real reach = 0;   // largest coordinate: what its rounding errors are measured by [world]
    vec3 velocity{0};
    Index material = 0;
    Real area = 0;            // of an emitter that shadow rays look for [m2]
    Index emitter = nothing;  // its number where shadow rays look for it
    Index shines = 0;         // 1: its front side sends out light
    Index smooth = nothing;   // which of World::corners has its normals
};

/// What the direct stage must know of a material.
struct Reflectance {
    Color albedo{0}, specular{0};
    Real shininess = 1;
    Index reflects = 0;  // 1: any light
    Index lobe = 0;      // 1: some of it into a glossy lobe
};

/// A scene laid out for the stages' loops. Shapes are numbered kind by kind: spheres, triangles, quads, discs.
struct World {
    Scene scene;  // without shapes; after its materials come those of the other squares of checkers
    RenderPlan plan;
    LargeVector<Sphere> spheres;
    LargeVector<Triangle> triangles;
    LargeVector<Quad> quads;
    LargeVector<Disc> discs;
    Index first_triangle = 0, first_quad = 0, first_disc = 0;
    std::vector<Emitter> emitters;
    LampTree lamp_tree;                     // of the emitters, where one is chosen
    LargeVector<SurfaceRecord> surfaces;    // by number
    LargeVector<vec3> normals;              // of meshes
    LargeVector<glm::ivec3> corners;        // which normals the corners of smooth triangles have
    std::vector<Reflectance> reflectances;  // of no surface, which is black, and then of each material
    std::vector<Index> other_squares;       // the material of a checker's other squares, by material; or nothing
    std::vector<vec3> checker_origins;      // where their squares begin, by number; empty where there are none
    std::vector<Box> boxes;                 // about all of a shape's motion, by number; where there is no tree
    Bvh bvh;
    Regions regions;  // which shapes enclose media, and where the eye is among them
};

World make_world(const Scene& scene, const Sampling& sampling);
inline World make_world(const Scene& scene) { return make_world(scene, sampling_of(scene)); }

}  // namespace rt
