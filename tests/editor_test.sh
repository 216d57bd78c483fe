#!/bin/sh
# What editors read: the flags for clangd compile fragments, VS Code's files are JSON whose tasks are there.
set -eu
flags=$(cat starter/compile_flags.txt)
for file in starter/fragments/hit_sphere.cpp starter/fragments/scatter_direction.cpp; do
    # shellcheck disable=SC2086
    (cd starter && ${CXX:-c++} $flags -fsyntax-only "fragments/${file##*/}")
done
python3 - <<'END'
import json, pathlib, re
files = {p.name: json.loads(p.read_text()) for p in pathlib.Path(".vscode").glob("*.json")}
assert set(files) == {"tasks.json", "launch.json", "extensions.json", "settings.json"}, sorted(files)
labels = [task["label"] for task in files["tasks.json"]["tasks"]]
for part in files["launch.json"]["configurations"]:
    assert part["preLaunchTask"] in labels, part["preLaunchTask"]
for name in ("tasks.json", "launch.json"):
    known = {entry["id"] for entry in files[name]["inputs"]}
    asked = set(re.findall(r"\$\{input:(\w+)\}", json.dumps(files[name])))
    assert asked == known, f"{name}: {asked ^ known}"
for pattern, schema in files["settings.json"]["evenBetterToml.schema.associations"].items():
    assert pathlib.Path(schema).exists(), schema
    assert any(re.fullmatch(pattern, f"/project/{p}") for p in pathlib.Path(".").rglob("*.toml")), pattern
    if "scene" in schema:
        other = [p for p in pathlib.Path("scenes").rglob("*.toml") if not re.fullmatch(pattern, f"/project/{p}")]
        assert not other, other
container = json.loads(pathlib.Path(".devcontainer/devcontainer.json").read_text())
assert (pathlib.Path(".devcontainer") / container["build"]["dockerfile"]).exists(), container["build"]
extensions = container["customizations"]["vscode"]["extensions"]
assert extensions == files["extensions.json"]["recommendations"], extensions
END

# The container's packages are those of the script that it sources: it names them, and has what installs them.
# shellcheck disable=SC2016
bash -euo pipefail -c 'root=/tmp; . "./$(sed -n "s/^COPY \([^ ]*\) .*/\1/p" .devcontainer/Dockerfile)"
    declare -F install_packages >/dev/null
    for list in $(grep -o "[$][a-z_]*packages" .devcontainer/Dockerfile); do list=${list#?}; [ -n "${!list}" ]; done' || exit 1
