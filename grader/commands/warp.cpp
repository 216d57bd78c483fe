#include "commands/warp.h"

#include <fmt/format.h>

#include "diagnosis/calls/arguments.h"
#include "files/files.h"
#include "judging/breakdown.h"
#include "programs/runner.h"
#include "report/picture.h"
#include "rt/files/scene_reader.h"
#include "rt/sampler.h"

namespace grade {

namespace {

constexpr int count = 3000, side = 480, wide = 2;  // as scenes/render_pictures and tests/variants/pictures.toml have it

/// White on black, y up, two pixels wide.
rt::Image dots(const Rows& answers) {
    rt::Image image(side, side);
    for (const Row& answer : answers) {
        const rt::vec2 at = (rt::vec2(answer[0], -answer[1]) + 1.1) / 2.2 * double(side) - double(wide / 2);
        if (!(at.x >= 0 && at.y >= 0 && at.x < side - wide && at.y < side - wide)) continue;
        for (int k = 0; k < wide * wide; ++k) image.at(int(at.x) + k % wide, int(at.y) + k / wide) = rt::Color(1);
    }
    return image;
}

}  // namespace

Rows calls_of_warp(const std::string& fragment, const std::string& words, const Toolchain& chain) {
    const auto signature = signature_of(fragment, read_text(chain.includes.front() / "rt/fragments.h").value_or(""));
    const bool is_point = signature && signature->result != "Real" && signature->result != "Color";
    if (!is_point || !are_readable(*signature) || signature->arguments.back().name != "u" ||
        signature->arguments.back().type != "vec2")
        throw rt::InputError(fmt::format(
            "{0}: makes no points of a vec2 u alone; expected a fragment that does, or a scene and --mine {0}",
            fragment));
    try {
        Rows calls(count, arguments_from_words(*signature, words));
        for (int i = 0; i < count; ++i) {
            const rt::vec2 u = rt::random_2d(1, rt::Bits(i), 0);
            std::copy_n(&u.x, 2, calls[std::size_t(i)].end() - 2);
        }
        return calls;
    } catch (const std::invalid_argument& error) {
        throw rt::InputError(error.what());
    }
}

int draw_warp(const std::string& fragment, const Rows& calls, Programs& programs, const fs::path& mine,
              const Toolchain& chain, double time_limit, const fs::path& out) {
    constexpr double some = 5;  // CPU seconds
    const auto answers = [&](const char* name, const fs::path& program) {
        const fs::path copy = programs.copy_for(name, program);
        Runner runner(copy, programs.sandbox(), copy.parent_path(), time_limit > 0 ? time_limit : some);
        return runner.probe(fragment, calls);
    };
    const auto right = answers("right", programs.with({}).program);
    if (const Fault* fault = std::get_if<Fault>(&right))
        throw std::runtime_error("the solution itself: " + fault->message);
    const auto own = answers("mine", mine);
    if (const Fault* fault = std::get_if<Fault>(&own)) {
        const std::string place = breakdown_of(programs, chain, fragment, calls);
        fmt::print("no picture of yours: {}\n{}{}", fault->message, place, place.empty() ? "" : "\n");
        return 1;
    }
    const Rows &a = std::get<Rows>(own), &b = std::get<Rows>(right);
    rt::write_png(out.string(), side_by_side({dots(a), dots(b)}), 1);
    fmt::print("{}: {} random u in the square from -1.1 to 1.1, seen from above: yours, the right ones\n", out.string(),
               count);
    return 0;
}

}  // namespace grade
