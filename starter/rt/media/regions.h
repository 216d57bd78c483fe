#pragma once

#include <vector>

#include "rt/batch.h"
#include "rt/media/nesting.h"
#include "rt/tree/bvh.h"

/// The regions that closed shapes enclose, where light travels through media: which of them a point is in, so that
/// paths that start inside one know it. Nobody needs this folder for the assignment.
///
/// A sphere and a closed mesh enclose a region each; the quads, discs, triangles and open meshes of one material
/// enclose one together. Where regions overlap, the smaller one is what is there.
namespace rt {

struct World;

struct Region {
    Index material = 0;
    std::vector<Index> shapes;  // of its boundary, by number
    Box box;                    // about all of its motion
    bool moves = false;
};

struct Regions {
    std::vector<Region> all;         // their numbers are 1, 2, ... by falling size; none where there are no media
    std::vector<Bits> of_shape;      // by the shape's number; 0: bounds none
    std::vector<Index> filled_with;  // by region, 0 too: the material whose medium is in it; -1: clear
    int bits = 1;                    // of a number in a nesting

    // where the camera's rays start
    Bits start = 0;           // the regions that all of them start in
    std::vector<Bits> asked;  // the regions that some may start in: each ray must ask

    bool any() const { return !all.empty(); }

    /// The material whose medium is around a ray; -1: none.
    Index medium(Bits inside) const { return filled_with[innermost(inside, bits)]; }

    /// Where a ray is once it has gone through a shape's surface.
    Bits crossed(Bits inside, Index shape, bool behind) const {
        const Bits region = of_shape[std::size_t(shape)];
        return region == 0 ? inside : behind ? left(inside, region, bits) : entered(inside, region, bits);
    }
};

/// The regions of a world whose shapes are laid out; none where its plan has no media.
Regions find_regions(const Scene& scene, const World& world);

/// Whether a point is inside a region; on its boundary it is not.
bool is_inside(const World& world, const Region& region, vec3 p, Real time);

/// All regions that a point is in.
Bits regions_around(const World& world, vec3 p, Real time);

/// Where a ray of the camera starts. On a boundary, that is the side to which it goes; near is moved beyond that
/// boundary.
Bits start_of(const World& world, Ray& ray, Real time);

}  // namespace rt
