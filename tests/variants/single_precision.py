#!/usr/bin/env python3
"""Grades the solution's fragments as they are in single precision: those that handout.md lists fail, and the hint says
so; the others pass.

    tests/variants/single_precision.py GRADE [--seeds N]
"""
import argparse
import pathlib
import re
import sys
import tempfile

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent))
from helpers import ROOT, record_of  # noqa: E402

SAYS = ("single precision", "about seven digits")

# What is computed of numbers of either precision has the lower one.
MIXED = """namespace {
using F3 = glm::vec3;
using D3 = glm::dvec3;
using glm::cross, glm::dot, glm::length;
template <class A, class B>
concept Mixed = (std::is_same_v<A, F3> && std::is_same_v<B, D3>) || (std::is_same_v<A, D3> && std::is_same_v<B, F3>);
[[maybe_unused]] F3 unit(F3 v) { return v / glm::length(v); }
[[maybe_unused]] float sqr(float x) { return x * x; }
template <class A, class B> requires Mixed<A, B> [[maybe_unused]] float dot(A a, B b) { return glm::dot(F3(a), F3(b)); }
template <class A, class B> requires Mixed<A, B> [[maybe_unused]] F3 cross(A a, B b) { return glm::cross(F3(a), F3(b)); }
template <class A, class B> requires Mixed<A, B> [[maybe_unused]] F3 operator+(A a, B b) { return F3(a) + F3(b); }
template <class A, class B> requires Mixed<A, B> [[maybe_unused]] F3 operator-(A a, B b) { return F3(a) - F3(b); }
template <class A, class B> requires Mixed<A, B> [[maybe_unused]] F3 operator*(A a, B b) { return F3(a) * F3(b); }
template <std::same_as<float> S> [[maybe_unused]] F3 operator*(S a, D3 b) { return a * F3(b); }
template <std::same_as<float> S> [[maybe_unused]] F3 operator*(D3 b, S a) { return a * F3(b); }
template <std::same_as<float> S> [[maybe_unused]] F3 operator/(D3 b, S a) { return F3(b) / a; }
template <std::same_as<double> S> [[maybe_unused]] F3 operator*(S a, F3 b) { return float(a) * b; }
template <std::same_as<double> S> [[maybe_unused]] F3 operator*(F3 b, S a) { return float(a) * b; }
template <std::same_as<double> S> [[maybe_unused]] F3 operator/(F3 b, S a) { return b / float(a); }
template <std::same_as<float> S> [[maybe_unused]] glm::vec2 operator*(S a, glm::dvec2 b) { return a * glm::vec2(b); }
}  // namespace
"""
TYPES = {"Real": "float", "vec3": "glm::vec3", "vec2": "glm::vec2", "Color": "glm::vec3"}
# Where one of both sides would decide, and where all of a sum is meant.
MORE = [("std::min(", "fmin("), ("std::max(", "fmax("), ("material.specular != glm::vec3(0)", "F3(material.specular) != F3(0)"),
        ("? light.position", "? F3(light.position)"),
        ("{pixel.low + stratified_2d(i, n, u) * (pixel.high - pixel.low), 1}",
         "{vec2(glm::vec2(pixel.low) + glm::vec2(stratified_2d(i, n, u)) * glm::vec2(pixel.high - pixel.low)), 1}")]


def in_float(text):
    """The text of a solution with its variables, constants and plain arguments in single precision."""
    region = re.search(r"    // BEGIN SOLUTION\n(.*?)    // END SOLUTION[^\n]*\n", text, re.DOTALL)
    head, body, tail = text[: region.start()], region[1], text[region.end() :]
    for name, narrow in TYPES.items():
        body = re.sub(rf"(?<!:)\b{name}\b", narrow, body)
    body = re.sub(r"(?<![\w.])(\d+\.\d+|\d+e-?\d+)(?![\w.])", r"\1f", body)
    for old, new in MORE:
        body = body.replace(old, new)
    arguments = ""
    for type_name, name in re.findall(r"\b(Real|vec3|vec2|Color) (\w+)(?=[,)])", re.findall(r"\n\w[^\n]*\) \{\n$", head)[-1]):
        head = re.sub(rf"(\b{type_name} ){name}\b(?=[,)])", rf"\g<1>{name}_in", head)
        arguments += f"    const {TYPES[type_name]} {name}({name}_in);\n"
    return head.replace("namespace rt {\n", "namespace rt {\n" + MIXED, 1) + arguments + body + tail


def listed():
    """The fragments for which handout.md says that `float` is too little."""
    sentence = re.search(r"`float` is too little for (.*?): with it", (ROOT / "handout.md").read_text(), re.DOTALL)
    return set(re.findall(r"`(\w+)`", sentence[1]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("grade", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--seeds", type=int, default=1)
    given = parser.parse_args()
    wrong, expected = [], listed()
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "fragments").mkdir()
        for path in sorted((ROOT / "solution").glob("*.cpp")):
            (place / "fragments" / path.name).write_text(in_float(path.read_text()))
        for seed in range(1, given.seeds + 1):
            for fragment in record_of([given.grade, place / "fragments", "--seed", seed, "--fresh"], cwd=ROOT)["fragments"]:
                name, verdict, how = fragment["name"], fragment["verdict"], fragment.get("finding", {}).get("how", "")
                if verdict != ("failed" if name in expected else "passed"):
                    wrong.append(f"{name}, seed {seed}: {verdict}; expected it to {'fail' if name in expected else 'pass'}")
                elif name in expected and not any(words in how for words in SAYS):
                    wrong.append(f"{name}, seed {seed}: \"{how}\"; expected a hint of digits")
    print("\n".join(wrong) or f"{len(expected)} fragments fail in single precision under {given.seeds} seeds, the others pass")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
