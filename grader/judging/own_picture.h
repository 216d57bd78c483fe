#pragma once

#include "checks/kit/check.h"
#include "programs/programs.h"
#include "record/record.h"

namespace grade {

/// A scene as some fragments of a submission draw it and as the solution's do, with the same random numbers.
struct Compared {
    Drawn mine, right;
    double exposure = 1;  // of the scene
};

struct ComparedSettings {
    int samples = 0;    // a pixel; 0: the scene's
    rt::ivec2 size{0};  // [pixel]; 0: the scene's
    std::uint64_t seed = 1;
    double time_limit = 0;  // CPU seconds of one picture; 0: some, and many times what the right one takes
};

/// What is drawn. Throws rt::InputError for a scene that is none.
Render render_of(const fs::path& scene, const ComparedSettings& settings);

/// Draws with two programs at a time. Throws rt::InputError for a scene that is none.
///
/// mine  a program with the submission's fragments
Compared draw_compared(Programs& programs, const fs::path& mine, const fs::path& scene,
                       const ComparedSettings& settings);

/// Adds the submission's own picture to a record of these programs: with all of its fragments but those that crash or
/// do not end, blanks for the others; small, and of few samples.
void add_own_picture(Record& record, Programs& programs, const fs::path& scene, std::uint64_t seed, double time_limit);

}  // namespace grade
