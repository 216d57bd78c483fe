#!/usr/bin/env python3
"""Each file includes what it uses: a header of the project, or of the standard library, that declares it, by itself or by the
project's headers that it includes. The compiler does not see what is missing where the files of a folder are compiled as
one, or after headers that are compiled before.

It reads texts: of the project's headers the types, functions and constants that stand at the beginning of a line; of a file
those of them that neither it nor what it includes declares, in whatever scope. Functions of one word, as `row` and `dot`,
are left out: many things are called so."""

import collections
import functools
import pathlib
import re

from helpers import end, expect

ROOTS = ["starter", "grader", "tests"]
# What students write, what is put before a student's text, and what the textbook's forms are made of.
OTHERS = re.compile(r"tests/(variants|hostile|example|course|cases)/|starter/fragments/|grader/textbook/(forms|mistakes)/|grader/textbook/watched.h")
MADE_BY_THE_BUILD = {"checks/fragment_checks.h": "checks/fragment_checks.h.in", "child/each_fragment.h": "child/each_fragment.h.in"}
STANDARD = {
    "algorithm": "sort stable_sort clamp min max minmax minmax_element max_element min_element find_if find_if_not count_if all_of "
                 "any_of none_of copy_if transform rotate reverse unique remove_if replace_if for_each lower_bound upper_bound "
                 "nth_element partial_sort stable_partition partition shuffle generate mismatch",
    "array": "array to_array", "atomic": "atomic", "chrono": "chrono", "deque": "deque", "exception": "exception_ptr",
    "filesystem": "filesystem", "fstream": "ifstream ofstream fstream", "functional": "function greater plus multiplies",
    "future": "promise shared_future future async", "limits": "numeric_limits", "map": "map multimap",
    "memory": "unique_ptr shared_ptr make_unique make_shared", "mutex": "mutex scoped_lock unique_lock once_flag call_once",
    "numbers": "numbers", "numeric": "accumulate iota inner_product gcd", "optional": "optional nullopt",
    "random": "mt19937_64 random_device uniform_int_distribution uniform_real_distribution normal_distribution",
    "regex": "regex smatch sregex_iterator regex_replace regex_search regex_match", "set": "set multiset", "span": "span",
    "sstream": "ostringstream istringstream stringstream", "stdexcept": "runtime_error logic_error invalid_argument out_of_range",
    "string": "string to_string stoi stod stoull", "string_view": "string_view", "system_error": "error_code system_error",
    "thread": "thread jthread this_thread", "variant": "variant get_if holds_alternative visit monostate", "vector": "vector"}
ALSO_IN = {"error_code": {"filesystem", "fstream"}, "string_view": {"string"}}  # which declare them as well
HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}
# at the beginning of a line, which nothing within a struct or a function is
DECLARED = re.compile(r"^(?! )(?:template <.*> *)?(?:\[\[.*\]\] )?(?:(?:inline|constexpr|const|extern|static) )*"
                      r"(?:(?:struct|class|enum class|enum|using|concept) (\w+)|[\w:<>,*& ]+?(?:\([\w&, ]*\)>)?[ &*>](\w+)(?=\(| =|;|\{))", re.MULTILINE)


def code_of(text):
    """Without comments and the insides of texts."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.DOTALL)
    return re.sub(r'//[^\n]*|("(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\')', lambda found: '""' if found[1] else "", text)


@functools.cache
def names_of(path):
    """All that a file declares, in whatever scope."""
    code = code_of(files[path])
    names = {found[1] or found[2] for found in DECLARED.finditer(code)} | set(re.findall(r"\b(?:class|typename|using) (\w+)", code))
    return names | set(re.findall(r"[\w>&*\]] [&*]*(?:\w+::)*(\w+)(?= = |[;,){]|\[\w*\]|\()", code))


def resolved(include):
    include = "checks/asked.h.in" if include.startswith("asked/") else MADE_BY_THE_BUILD.get(include, include)
    return next((path for root in ROOTS if (path := pathlib.Path(root) / include) in files), None)


def reached_from(path):
    """All headers, the project's as paths, others by name."""
    seen, open_ones = set(), [path]
    while open_ones:
        for quoted, other in re.findall(r'^#include (?:"([^"]+)"|<([^>]+)>)', files[open_ones.pop()], re.MULTILINE):
            header = other or resolved(quoted)
            if header and header not in seen:
                seen.add(header)
                open_ones += [] if other else [header]
    return seen


files = {path: path.read_text() for root in ROOTS for path in sorted(pathlib.Path(root).rglob("*"))
         if path.suffix in (".h", ".cpp", ".in") and not OTHERS.search(str(path))}
declared_by = collections.defaultdict(set)
for path, text in files.items():
    if path.suffix == ".h" or path.name.endswith(".h.in"):
        for found in DECLARED.finditer(code_of(text)):
            declared_by[found[1] or found[2]].add(path)
nested = set(re.findall(r"^ +(?:struct|class|enum class|enum|using) (\w+)", "\n".join(files.values()), re.MULTILINE))
uses = 0
for path, text in files.items():
    if path.suffix not in (".h", ".cpp"):
        continue
    code, reached = re.sub(r"^#.*", "", code_of(text), flags=re.MULTILINE), reached_from(path) | {path}
    for name in sorted(set(re.findall(r"std::(?:ranges::)?(\w+)", code))):
        header = HEADER_OF.get(name)
        expect(not header or reached & {header, *ALSO_IN.get(name, ())}, f"{path}: std::{name} without <{header}>")
    known = set().union(*(names_of(header) for header in reached if header in files))
    types = set(re.findall(r"(?<![\w:.])(?:[a-z]\w+::)*([A-Z]\w*[a-z]\w*)\b", code)) - nested
    code = re.sub(r"\b(?:std|fs|fmt|glm|ranges)::[\w:]+", "", code)
    called = set(re.findall(r"(?<![\w:.>&])(?:[a-z]\w+::)*([a-z]+_\w+)\(", code))
    for name in sorted((types | called) & declared_by.keys() - known):
        lower = [str(header) for header in declared_by[name] if header.parts[0] in ROOTS[:ROOTS.index(path.parts[0]) + 1]]
        expect(not lower, f"{path}: {name} is declared by {' or '.join(sorted(lower))}, which it does not include")
    uses += len((types | called) & declared_by.keys())
expect(uses > 3000, f"only {uses} uses found")
end(f"{uses} uses, each with its header")
