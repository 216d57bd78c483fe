#!/usr/bin/env python3
"""The JSON schemas of scenes and of assignment.toml: they know the keys that the programs know, take what is in the project, and
refuse what is wrong. The language server of the editor's settings is asked as well, where it is installed. Skipped where
there is no jsonschema."""
import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import tomllib

from helpers import ROOT, end, expect, skip

try:
    import jsonschema
except ImportError:
    skip("there is no Python package jsonschema here")


def schema(path):
    read = json.loads((ROOT / path).read_text())
    jsonschema.Draft7Validator.check_schema(read)
    return jsonschema.Draft7Validator(read)


def keys_in_code(files):
    """The lists of only({...})."""
    text = "".join((ROOT / file).read_text() for file in files)
    return {frozenset(re.findall(r'"(\w+)"', keys)) for keys in re.findall(r"only\(\s*\{([^}]*)\}", text)}


def keys_in(part):
    """Those of each object of a schema that refuses others."""
    if isinstance(part, list):
        return set().union(*map(keys_in, part)) if part else set()
    if not isinstance(part, dict):
        return set()
    own = {frozenset(part["properties"])} if part.get("additionalProperties") is False else set()
    return own.union(*map(keys_in, part.values()))


def broken(text, old, new):
    assert text.count(old) >= 1, old
    return tomllib.loads(text.replace(old, new, 1))


scenes = schema("scenes/scene.schema.json")
files = sorted((ROOT / "scenes").rglob("*.toml"))
expect(len(files) > 40, f"{len(files)} scenes; expected those of scenes/")
for file in files:
    for error in scenes.iter_errors(tomllib.loads(file.read_text())):
        expect(False, f"{file}: {error.json_path}: {error.message}")

ball = (ROOT / "scenes/white_ball.toml").read_text()
for old, new in [("albedo = 0.8", "albedo = 1.2"), ("albedo = 0.8", "albdo = 0.8"), ("albedo = 0.8", "checker = { albedo = 0.5 }"),
                 ("albedo = 0.8", "checker = { albedo = 0.5, size = 0 }"), ("radius = 1", "radius = 0"), ("radius = 1", ""),
                 ('type = "sphere"', 'type = "ball"'), ("eye = [0, 0, 5]", "eye = [0, 0]"), ("irradiance = 3", "irradiance = -3"),
                 ("[camera]", "[render]\nsamples = 1.5\n[camera]"), ("[camera]", '[render]\nsampler = "grid"\n[camera]')]:
    expect(not scenes.is_valid(broken(ball, old, new)), f"a scene with {new!r} in place of {old!r} is taken")

assignments = schema("grader/assignment/assignment.schema.json")
known = keys_in_code(["grader/assignment/assignment.cpp"])
expect(keys_in(assignments.schema) == known, f"keys of assignment.toml: {keys_in(assignments.schema) ^ known}")
text = (ROOT / "assignment.toml").read_text()
for error in assignments.iter_errors(tomllib.loads(text)):
    expect(False, f"assignment.toml: {error.json_path}: {error.message}")
first = '{ name = "integrate_uniform", points = 2 }'
for new in ('{ name = "integrate_uniform", given = true }', first + ",\n" + first.replace("uniform", "x")):
    expect(assignments.is_valid(broken(text, first, new)), f"an assignment with {new!r} is refused")
for new in ('{ name = "integrate_uniform" }', '{ name = "integrate_uniform", points = -1 }', '{ name = "x", points = 1, visible = true }',
            '{ name = "x", points = 1, visibility = "no" }'):
    expect(not assignments.is_valid(broken(text, first, new)), f"an assignment with {new!r} is taken")
expect(assignments.is_valid(tomllib.loads(text + "\n[theory]\npoints = 16\n")), "a theory part is refused")

# What the editor says: its TOML extension is this program's.
taplo = shutil.which("taplo", path=f"{ROOT}/build/pages/bin:/usr/local/bin:/usr/bin")


def editor_takes(path, files):
    command = [taplo, "check", "--schema", (ROOT / path).as_uri(), *map(str, files)]
    return subprocess.run(command, capture_output=True, check=False).returncode == 0


if taplo:
    expect(editor_takes("scenes/scene.schema.json", files), "taplo refuses a scene of the project")
    expect(editor_takes("grader/assignment/assignment.schema.json", [ROOT / "assignment.toml"]), "taplo refuses assignment.toml")
    with tempfile.TemporaryDirectory() as folder:
        wrong = pathlib.Path(folder) / "ball.toml"
        wrong.write_text(ball.replace("albedo", "albdo"))
        expect(not editor_takes("scenes/scene.schema.json", [wrong]), "taplo takes an unknown key")
else:
    print("there is no taplo: what the editor itself says is not tested")

end("as the programs have it")
