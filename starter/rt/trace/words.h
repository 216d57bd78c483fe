#pragma once

#include <fmt/format.h>

#include "rt/trace.h"

/// How a trace puts things: six digits, a name and then what it has to say. Nobody needs this file for the assignment.
namespace rt {

inline std::string text(Real x) { return fmt::format("{:.6g}", x); }
inline std::string text(vec2 v) { return fmt::format("({:.6g}, {:.6g})", v.x, v.y); }
inline std::string text(vec3 v) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x, v.y, v.z); }

/// A line of a trace.
///
/// name  of the fragment, or of what the framework does itself; empty: the last line goes on
template <class... Values>
void tell(Told& told, const char* name, fmt::format_string<Values...> format, Values&&... values) {
    told.text += fmt::format("  {:<20}", name) + fmt::format(format, std::forward<Values>(values)...) + '\n';
}

/// Light that arrives at the film: what is seen, times what the ray carries.
inline void tell_added(Told& told, Color light) {
    told.light += light;
    tell(told, "  adds", "{}", text(light));
}

inline std::string distance_text(Real metres) { return metres < inf ? text(metres) + " m" : "infinity"; }

/// The fragment that meets a shape; that of discs is the framework's.
inline const char* hit_name(const World& world, Index shape) {
    return shape < world.first_triangle ? "hit_sphere"
           : shape < world.first_quad   ? "hit_triangle"
           : shape < world.first_disc   ? "hit_quad"
                                        : "hit disc";
}

/// The random numbers of lane i in a dimension of the waves.
inline vec2 numbers_of(const Wave& wave, int i, int dimension) {
    Numbers u;
    wave.draw_2d(dimension, wave.batch.count, u);
    return u.at(i);
}
inline Real number_of(const Wave& wave, int i, int dimension) {
    Numbers u;
    wave.draw_1d(dimension, wave.batch.count, u);
    return u.x[i];
}

/// What lights the surface of lane i: lamps of all kinds, each with its shadow ray.
void trace_lights(const Wave& wave, int i, Told& told);

/// What of the lamps' light is scattered at a point in the medium of a material, as lane i has it.
void trace_scattered(const Wave& wave, int i, Index material, vec3 point, Told& told);

}  // namespace rt
