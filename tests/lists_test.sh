#!/usr/bin/env bash
# lists_test.sh: the lists of fragments that the build makes follow fragments.h, assignment.toml, solution/ and checks/; where these do
# not agree, the build says so.
set -uo pipefail
# shellcheck source=tests/expect.sh
. "$(dirname "$0")/expect.sh"

# A project of its own with nothing but the lists.
mkdir -p "$work/starter/rt" "$work/grader"
cp -r grader/checks grader/child grader/cmake grader/protocol "$work/grader"
cp -r solution "$work"
cat >"$work/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.22)
project(lists NONE)
add_subdirectory(grader)
CMAKE
cat >"$work/grader/CMakeLists.txt" <<'CMAKE'
include(cmake/lists.cmake)
make_lists(${CMAKE_CURRENT_BINARY_DIR})
CMAKE
checks=$work/build/grader/checks/fragment_checks.h functions=$work/build/grader/child/each_fragment.h
fresh() { cp starter/rt/fragments.h "$work/starter/rt" && cp assignment.toml "$work"; }
configure=(cmake -G Ninja -S "$work" -B "$work/build")

fresh
expect 0 "Generating done" "${configure[@]}"
solutions=(solution/*.cpp)
expect 0 "${#solutions[@]}" grep -c 'visit("\(.*\)", rt::\1);' "$functions"

# scenes beside the checks, as texts
expect 0 '{"hollow_sphere.toml", R"toml(# color_bleeding' cat "$work/build/grader/checks/scene_texts.cpp"
printf '[camera]\neye = {eye}\nup = [0, 0, 1]  # a; b\n' >"$work/grader/checks/fog.toml"
expect 0 "Generating done" "${configure[@]}"
expect 0 $'{"fog.toml", R"toml([camera]\neye = {eye}\nup = [0, 0, 1]  # a; b\n)toml"},' cat "$work/build/grader/checks/scene_texts.cpp"

# a new fragment: a declaration, a line of the assignment, a file of checks
declare_one() { sed -i 's|^// 3 sampling|Real fog(Real extinction, Real way);\n&|' "$work/starter/rt/fragments.h"; }
assign_one() { sed -i 's|.*name = "whitted", points.*|&\n  { points = 2, name = "fog" }, # { name = "mist" }|' "$work/assignment.toml"; }
declare_one
expect 1 'solution/fog.cpp: is missing; expected the solution of the fragment fog of fragments.h' "${configure[@]}"
touch "$work/solution/fog.cpp"
expect 1 'grader/checks/fog.cpp: is missing; expected the checks of the fragment fog of fragments.h' "${configure[@]}"
touch "$work/grader/checks/fog.cpp"
# without a line of the assignment it is left out: in the lists, but last
expect 0 'assignment.toml leaves fog out: handed out filled in, not graded' "${configure[@]}"
expect 0 'Checks check_fog(Generator& random);' cat "$work/build/grader/asked/fog.h"
expect 0 $'visit("scatter_direction", rt::scatter_direction);\n    visit("fog", rt::fog);' cat "$functions"
assign_one
expect 0 "Generating done" "${configure[@]}"
expect 0 'Checks check_fog(Generator& random);' cat "$checks"
expect 0 'visit("fog", rt::fog);' cat "$functions"
expect 0 $'{"whitted", check_whitted},\n    {"fog", check_fog},' cat "$checks"

fresh
expect 1 'grader/checks/fog.cpp: no fragment is named fog; expected one of fragments.h, or the file in checks/kit' "${configure[@]}"
assign_one
rm "$work/grader/checks/fog.cpp"
fresh
expect 1 'solution/fog.cpp: no fragment is named fog; expected one that starter/rt/fragments.h declares' "${configure[@]}"
rm "$work/solution/fog.cpp"

# a fragment that a course leaves out, also where another one has its name in it
sed -i '/name = "moved"/d' "$work/assignment.toml"
expect 0 'assignment.toml leaves moved out' "${configure[@]}"
expect 0 $'{"scatter_direction", check_scatter_direction},\n    {"moved", check_moved},' cat "$checks"

# the order is the assignment's
fresh
sed -i 's/"phong"/"here"/; s/"shadow_ray"/"phong"/; s/"here"/"shadow_ray"/' "$work/assignment.toml"
expect 0 "Generating done" "${configure[@]}"
expect 0 $'check_shadow_ray},\n    {"phong", check_phong},' cat "$checks"

end
