#pragma once

#include <string>
#include <vector>

#include "rt/render.h"
#include "rt/stages/stages.h"

/// What raytrace --pixel tells: along the paths of a pixel, each fragment that is called, and what it answers. Nobody
/// needs this file nor trace/ for the assignment.
///
/// The stages are not touched: where a trace is asked for, the fragments are asked once more, for one lane after
/// another, with the same arguments and random numbers. Rays, hits and weights are the stages' own.
namespace rt {

/// What is told of one sample of the pixel.
struct Told {
    std::string text;
    Color light{0};  // the sum of what the text says is added
};

struct Trace {
    std::vector<Told> samples;  // by slot

    Told& of(const Batch& b, int i) { return samples[std::size_t(b.slot[i])]; }
};

/// The first rays: through which point of the film, of the lens, at which time.
void trace_camera(const World& world, const CameraWork& work, const Batch& batch, Trace& trace);

/// What the rays of a wave meet, what shines there, and what lights it.
void trace_wave(const Wave& wave, Trace& trace);

/// How the paths go on.
void trace_ways(const Wave& wave, Trace& trace);

/// The trace of a pixel, and its colour as the picture has it.
struct PixelTrace {
    Trace trace;
    std::vector<Color> radiance;  // of each sample, as the stages have gathered it
    Color mean{0};
};
PixelTrace trace_paths(const Scene& scene, const RenderSettings& settings, int x, int y);

}  // namespace rt
