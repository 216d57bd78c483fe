#pragma once

#include <string>
#include <vector>

#include "rt/files/mitsuba.h"
#include "rt/world.h"

/// The parts of a Mitsuba scene, as XML. Nobody needs this file for the assignment.
namespace rt {

/// x, y, z
std::string coordinates(vec3 v);

std::string xml_number(const char* name, Real x);
std::string xml_color(const char* name, Color c);
std::string xml_point(const char* name, vec3 p);

bool has_medium(const Material& m);

/// Whether light goes straight through the surface: a boundary that only encloses a medium.
bool is_null_boundary(const Material& m);

/// The surface of a material, with the identifier `id`, if there is any; of a checker, on this quad.
std::string mitsuba_surface(const Material& m, const std::string& id, const Quad* quad = nullptr);

/// What is behind a surface, with the identifier `id`.
std::string mitsuba_medium(const Medium& medium, const std::string& id);

/// A reference to the medium around a point, under this name; empty where there is none.
std::string mitsuba_medium_at(const World& world, Bits inside, const char* name);

/// Adds the scene's shapes; materials and media have the identifiers materialN and mediumN.
///
/// world  of the scene, where it has media
void add_mitsuba_shapes(const Scene& scene, const World* world, const std::string& stem, MitsubaFiles& out);

/// Which of Mitsuba's integrators follows the same paths, and how far.
struct MitsubaPaths {
    bool media = false;   // volpath, else path
    int max_depth = -1;   // edges of a path; -1: any number
    std::string comment;  // where the two differ; empty: nowhere
};

/// Decides the integrator, and adds what cannot be said to `unsaid`.
MitsubaPaths mitsuba_paths(const Scene& scene, std::vector<std::string>& unsaid);

}  // namespace rt
