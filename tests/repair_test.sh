#!/usr/bin/env bash
# repair_test.sh BUILD: a hint says in which line of the student's own file the mistake is, and what must stand there, in
# whatever way the fragment is written; what cannot be read so is graded all the same.
set -uo pipefail
grade=$1/grader/grade
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"

# fragment NAME: its file, from standard input, in the namespace
fragment() {
    mkdir -p "$work/$1"
    { printf '#include "rt/fragments.h"\n\nnamespace rt {\n\n'; cat; printf '\n}\n'; } >"$work/$1/$1.cpp"
}
# hint NAME POINTS WORDS...: what the record says of it
hint() {
    local name=$1
    expect 0 "$2" "$grade" "$work/$name" "$name" --seed 1 --json "$work/$name.json"
    shift 2
    for words; do expect 0 "$words" grep message "$work/$name.json"; done
}

fragment integrate_stratified <<'END'
namespace {

struct Interval {
    Real from, to;
    Real width() const { return to - from; }
    Real at(Real t) const { return from + width() * t * t; }
};

}

Real integrate_stratified(const Function& f, std::span<const Stratum> strata) {
    const auto mean = [&f](const Interval& all, std::span<const Real> numbers) {
        Real sum = 0;
        for (const Real t : numbers) sum += f(all.at(t));
        return sum / static_cast<Real>(numbers.size());
    };
    Real total = 0;
    for (const auto& [low, high, u] : strata) {
        if (u.empty()) continue;
        const Interval all{low, high};
        total += all.width() * mean(all, u);
    }
    return total;
}
END
hint integrate_stratified "0 of 3" "line 10"

# two mistakes
fragment refracted_direction <<'END'
vec3 refracted_direction(vec3 d, vec3 n, Real ior_from, Real ior_to) {
    const Real ratio = ior_from / ior_to;
    const Real c = dot(d, n);
    const Real rest = 1 - ratio * ratio * (1 - c * c);
    if (rest < 0) return d - 2 * c * n;
    return ratio * d + (ratio * c - std::sqrt(rest)) * n;
}
END
hint refracted_direction "0 of 3" " in line 7, \`c = dot(d, n)\`, and \`vec3(0, 0, 0)\` in place of \`d - 2 * c * n\` in line 9"

# a product number by number in place of a dot product
fragment mirror_direction <<'END'
vec3 mirror_direction(vec3 d, vec3 n) {
    const vec3 along = (d * n) * n;
    return d - 2.0 * along;
}
END
hint mirror_direction "0 of 2" "with \`dot(d, n)\` in place of \`d * n\` in line 6" "every answer is right"

# macros, also over several lines, and conditions
fragment moved <<'END'
#include <cmath>
#ifdef __cplusplus
#define SECONDS 2
#else
#define SECONDS none
#endif
#define ADDED(a, b) \
    ((a) + \
     (b))
vec3 moved(vec3 point, vec3 velocity, Real time) {
    const vec3 way = ADDED(
        velocity * time,
        0.5 * velocity);
    return std::floor(SECONDS * M_PI) == 6 ? ADDED(point, way) : point;
}
END
hint moved "0 of 2" "in place of \`(velocity * time) + (0.5 * velocity)\` in line 15" "every answer is right"

# in a part that is left out nothing is put in
fragment shutter_time <<'END'
#define TWICE(x) x x
#define MUCH(x) TWICE(TWICE(TWICE(TWICE(TWICE(TWICE(TWICE(TWICE(x))))))))
#define ALL MUCH(MUCH(MUCH(;)))
#if 0
ALL
#endif
Real shutter_time(const Shutter& shutter, Real u) { return shutter.open + u * u * (shutter.close - shutter.open); }
END
hint shutter_time "0.4 of 2" "line 11"

# no textbook has it so: what must stand there is told; some changes make a loop that does not end
fragment free_flight <<'END'
Real free_flight(Real extinction, Real u) {
    Real left = 1, step = 0.5;
    while (step > 1e-18) {  // endless with another step
        if (left - step >= 1 - u) left -= step;
        step = step / 2;
    }
    return -std::log(left) / (extinction + 0.3 * std::sin(u));
}
END
hint free_flight "of 4" "with \`extinction\` in place of \`extinction + 0.3 * sin(u)\` in line 11" "every answer is right"

end
