#pragma once

#include "asked/light_sample.h"
#include "checks/kit/kit.h"

/// What the checks of light_sample share: lamps, and where on them a sample is; and those of them that need much text.
namespace grade::light_sample {

/// A lamp of the kind, anywhere and turned anyhow.
rt::Emitter emitter(Generator& random, rt::Emitter::Kind kind);

/// The point of a flat light in units of its half edges or its radius, across and along.
rt::vec2 on_light(const rt::Emitter& light, rt::vec3 p, const rt::LightSample& s);

/// How far a sample is off the light's surface, in the light's size.
double off_light(const rt::LightSample& s, const rt::Emitter& light, rt::vec3 p, rt::vec2 u);

/// off_light of all samples; `unit` of it: "size" or "radius".
Statistic samples_on_light(const std::string& unit, const std::string& says);

/// side x side samples of a lamp from a point, over the square of u, and some of them again.
std::function<Rows(Generator&)> samples_of(const rt::Emitter& light, rt::vec3 p, int side);

Check flat_light(Generator& random, rt::Emitter::Kind kind, const char* name);
Check sphere_light(Generator& random);

/// Small lights at many places: which powers of distance, cosine and area the estimate has.
Check many_places();

/// Irradiance of a surface, against the formulas of Lambert and others: a quad anywhere, a disc that the surface faces,
/// a sphere.
Check irradiance(Generator& random);

}  // namespace grade::light_sample
