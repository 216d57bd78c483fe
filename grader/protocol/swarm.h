#pragma once

#include <cstdint>
#include <vector>

/// Calls of fragments that are too many for a pipe: the child makes up the arguments itself. Call i depends on the seed
/// and on i alone.
namespace grade {

enum class Swarm : std::uint32_t {
    mesh,          // a ray from within a closed mesh of eight triangles, half of them aimed at edges and corners
    leave_sphere,  // a shadow ray from where a ray met a sphere, from either side
    leave_quad,
    leave_triangle,
};

struct SwarmRequest {
    Swarm kind;
    std::uint64_t seed, first, count;
};

/// For each call one number, all at sizes of 2^-40 to 2^40: of a mesh the distance at which the ray meets it; of the
/// others that at which the ray meets again the surface that it leaves, inf where it does not, nan where it never met
/// it.
std::vector<double> swarm(const SwarmRequest& request);

}  // namespace grade
