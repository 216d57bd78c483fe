"""The expressions of a fragment's source: where each stands and what type it has, as Clang says."""
import json
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]

# around an expression, and not written by anybody
wrappers = {"ImplicitCastExpr", "MaterializeTemporaryExpr", "ExprWithCleanups", "CXXBindTemporaryExpr", "ConstantExpr", "ParenExpr"}


def type_of(node):
    written = node.get("type", {})
    name = re.sub(r"\bconst\b|&|rt::", "", written.get("desugaredQualType", written.get("qualType", ""))).strip()
    if name in ("double", "Real") or name.endswith("value_type"):
        return "real"
    if name in ("int", "unsigned long", "size_t", "std::size_t", "unsigned int"):
        return "int"
    for length in "23":
        if f"vec<{length}, double" in name or name in (f"vec{length}", f"dvec{length}"):
            return f"vec{length}"
    return {"Color": "vec3"}.get(name, name)


class Expression:
    """As it is written, with what is around it."""

    def __init__(self, begin, end, type_, node, parent):
        self.begin, self.end, self.type, self.node, self.parent = begin, end, type_, node, parent
        self.kind, self.parts = node["kind"], []

    def is_name(self):
        return self.kind == "DeclRefExpr" or (self.kind == "MemberExpr" and all(part.is_name() for part in self.parts))


class Source:
    """The text of a fragment's file, its expressions and its statements."""

    def __init__(self, name, text, compiler="clang++"):
        self.name, self.text = name, text
        self.expressions, self.statements, self.parameters, self.locals = [], [], [], []
        for declaration in self.dumped(compiler):
            body = [inner for inner in declaration.get("inner", []) if inner["kind"] == "CompoundStmt"]
            if declaration["kind"] == "FunctionDecl" and declaration["name"] == name and body:
                self.parameters = [(inner["name"], type_of(inner)) for inner in declaration["inner"]
                                   if inner["kind"] == "ParmVarDecl" and "name" in inner]
                self.body = self.range_of(body[0])
                self.walk(body[0], None)
                return
        raise ValueError(f"{name}: no definition of it is in its file")

    def dumped(self, compiler):
        file = ROOT / "solution" / f"{self.name}.cpp"
        done = subprocess.run([compiler, "-std=c++20", "-x", "c++", "-I", ROOT / "starter", "-w", "-fsyntax-only", "-Xclang", "-ast-dump=json",
                               "-Xclang", f"-ast-dump-filter={self.name}", "-iquote", file.parent, "-"],
                              input=self.text, capture_output=True, text=True, check=True)
        decoder, at = json.JSONDecoder(), 0
        while at < len(done.stdout.rstrip()):
            at = done.stdout.index("{", at)
            node, at = decoder.raw_decode(done.stdout, at)
            yield node

    @staticmethod
    def range_of(node):
        begin, end = node.get("range", {}).get("begin", {}), node.get("range", {}).get("end", {})
        if "offset" not in begin or "offset" not in end:
            return None
        return begin["offset"], end["offset"] + end["tokLen"]

    def walk(self, node, parent):
        kind, place = node.get("kind", ""), self.range_of(node)
        if place and not (self.body[0] <= place[0] and place[1] <= self.body[1]):
            place = None
        if kind == "VarDecl" and place and "name" in node:
            self.locals.append((place[1], node["name"], type_of(node)))
        is_statement = kind.endswith(("Stmt", "Operator")) or kind == "CXXMemberCallExpr"
        if place and is_statement and parent is None:
            self.statements.append((place, node))
        is_expression = place and (kind.endswith(("Expr", "Operator", "Literal")))
        if not is_expression:
            for inner in node.get("inner", []):
                self.walk(inner, parent if kind not in ("LambdaExpr",) else None)
            return
        outer, type_ = place, type_of(node)
        while "inner" in node:
            inner = self.range_of(node["inner"][0])
            is_wrapper = kind in wrappers or (kind == "CXXConstructExpr" and inner == place) or "(anonymous" in type_of(node)
            if not inner or not is_wrapper:
                break
            node = node["inner"][0]
            kind, place = node["kind"], inner
        expression = Expression(*outer, type_, node, parent)
        expression.inside = place
        self.expressions.append(expression)
        if parent:
            parent.parts.append(expression)
        for inner in node.get("inner", []):
            self.walk(inner, expression)

    def of(self, expression):
        return self.text[expression.begin:expression.end]
