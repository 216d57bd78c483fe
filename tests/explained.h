#pragma once

#include <fstream>
#include <iterator>

#include "catch.h"
#include "checks/kit/draw.h"
#include "checks/kit/probe_check.h"
#include "child/probes.h"
#include "diagnosis/explain.h"
#include "protocol/rows.h"

/// What tests of the diagnosis share: calls of fragments, and answers with a mistake.
namespace grade {

inline std::string header() {
    std::ifstream file("starter/rt/fragments.h");
    return {std::istreambuf_iterator<char>(file), {}};
}

inline Signature declared(const std::string& fragment) { return signature_of(fragment, header()).value(); }

/// The answers of the solution, or of it with a mistake: made of its arguments, or of its answer.
inline Ask answers(const std::string& fragment, std::function<void(Row&)> arguments = {},
                   std::function<void(Row&)> answer = {}) {
    return [=](const Rows& rows) {
        Rows all;
        for (Row row : rows) {
            if (arguments) arguments(row);
            Row out = probe(fragment, row);
            if (answer) answer(out);
            all.push_back(out);
        }
        return all;
    };
}

inline Finding found(const std::string& fragment, const Rows& rows, const Ask& mine) {
    return explain(declared(fragment), rows, mine, answers(fragment));
}

/// So many calls, each drawn anew.
template <class F>
inline Rows calls(F draw, int count = 60) {
    Generator random(3);
    return rows_of(count, draw)(random);
}

inline Rows mirrors() {
    return calls([](Generator& random) { return row(box(random, -3, 3), direction(random)); });
}

inline Rows squares() {
    return calls([](Generator& random) { return row(square(random)); });
}

/// Lamps of any kind, seen from any side.
inline Rows lamps(int count = 200) {
    return calls(
        [](Generator& random) {
            rt::Emitter lamp;
            lamp.kind = rt::Emitter::Kind(whole_between(random, 0, 2));
            const rt::Frame frame = rt::frame_about(direction(random));
            lamp.quad = {box(random, -2, 2), between(random, 0.1, 0.3) * frame.x, between(random, 0.1, 0.3) * frame.y};
            lamp.disc = {lamp.quad.center, frame.z, between(random, 0.1, 0.3)};
            lamp.sphere = {lamp.quad.center, between(random, 0.1, 0.3)};
            return row(lamp, lamp.quad.center + between(random, 1, 3) * direction(random), square(random));
        },
        count);
}

/// The solution's samples of lamps, with another density, made of the cosine at the lamp.
template <class Density>
inline Ask with_density(Density density) {
    return [=](const Rows& rows) {
        Rows all = answers("light_sample")(rows);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            RowReader reader(rows[k]);
            const auto lamp = read(reader, Tag<rt::Emitter>{});
            if (lamp.kind == rt::Emitter::Kind::sphere) continue;
            const rt::vec3 d(all[k][0], all[k][1], all[k][2]);
            const double cosine = -rt::dot(d, rt::unit(rt::normal(lamp)));
            all[k][4] = density(lamp, cosine, rt::sqr(all[k][3]) / rt::area(lamp));
        }
        return all;
    };
}

}  // namespace grade
