"""Typed mistakes of a fragment: what a student may write in place of each expression of a right one.

A mistake is another text in place of one expression or statement. What does not compile is left out by whoever compiles it.
"""
import collections
import re

from expressions import Source, type_of

# kind: of the list in README.md; begin, end, text: the change
Mistake = collections.namedtuple("Mistake", "kind begin end text")

arithmetic = {"+": "-*", "-": "+*", "*": "/+", "/": "*-"}
compared = {"<": ("<=", ">"), "<=": ("<", ">="), ">": (">=", "<"), ">=": (">", "<="), "==": ("!=",), "!=": ("==",)}
exchanged = {"sqrt": ["rt::sqr"], "safe_sqrt": ["rt::sqr", "std::sqrt"], "abs": ["-"], "min": ["std::max"], "max": ["std::min"],
             "floor": ["std::ceil", "std::round"], "ceil": ["std::floor", "std::round"], "cos": ["std::sin"], "sin": ["std::cos"],
             "log": ["std::exp"], "log1p": ["std::log", "-rt::exp"], "exp": ["rt::log", "std::expm1"], "expm1": ["std::exp"],
             "acos": ["std::cos", "std::asin"], "asin": ["std::sin", "std::acos"], "tan": ["std::atan"], "atan": ["std::tan"],
             "dot": ["glm::distance"], "sqr": ["std::sqrt"], "length": ["rt::largest"]}
put_around = {"real": {"power": ["std::sqrt({})", "rt::sqr({})"], "constant": ["2 * ({})", "0.5 * ({})", "1 - ({})", "1 / ({})"], "sign": ["-({})"]},
              "vec3": {"constant": ["2.0 * ({})", "0.5 * ({})"], "sign": ["-({})"]},
              "vec2": {"constant": ["2.0 * ({})", "0.5 * ({})"], "sign": ["-({})"], "exchanged": ["rt::vec2(({0}).y, ({0}).x)"]},
              "bool": {"branch": ["!({})", "true", "false"]},
              "int": {"constant": ["({}) + 1", "({}) - 1"]}}
# of positive numbers and unit vectors the same: no mistakes to count, but some to recognise
also_around = {"real": ["std::abs({})", "std::max({}, 0.0)", "std::min({}, 1.0)"], "vec3": ["rt::unit({})"]}
most_names = 8  # that stand in the place of one expression
constants = {"real": ["0.0", "1.0"], "vec3": ["rt::vec3(0)", "rt::vec3(1)"]}


class Fragment(Source):
    """And the mistakes that are made in it."""

    def mistakes(self, with_added_calls=False):
        """All of them, each text once."""
        seen, all_ = set(), []
        for mistake in [*self.listed(), *(self.added_calls() if with_added_calls else [])]:
            text = self.with_mistake(mistake)
            plain = re.sub(r"\s+", "", text)
            if plain not in seen and text != self.text:
                seen.add(plain)
                all_.append(mistake)
        return all_

    def with_mistake(self, mistake):
        return self.text[:mistake.begin] + mistake.text + self.text[mistake.end:]

    def listed(self):
        for expression in self.expressions:
            if expression.kind in ("BinaryOperator", "CXXOperatorCallExpr", "CompoundAssignOperator"):
                yield from self.of_operator(expression)
            if expression.kind == "UnaryOperator" and expression.node["opcode"] in "-!":
                yield self.put("sign", expression, self.of(expression.parts[0]))
            if expression.kind in ("CallExpr", "CXXMemberCallExpr"):
                yield from self.of_call(expression)
            if expression.kind in ("CXXFunctionalCastExpr", "CXXStaticCastExpr") and expression.type == "real":
                yield self.put("integer division", expression, self.of(expression.parts[-1]) if expression.parts else "0")
            if expression.kind in ("IntegerLiteral", "FloatingLiteral"):
                yield from self.of_number(expression)
            if expression.kind == "ConditionalOperator":
                yield self.put("branch", expression, self.of(expression.parts[1]))
                yield self.put("branch", expression, self.of(expression.parts[2]))
            if expression.kind == "InitListExpr" or expression.kind in ("CXXTemporaryObjectExpr", "CXXConstructExpr"):
                yield from self.of_list(expression)
        for expression in self.expressions:
            yield from self.of_any(expression)
        for place, node in self.statements:
            yield from self.of_statement(place, node)

    def added_calls(self):
        for expression in self.expressions:
            if expression.kind not in ("InitListExpr", "LambdaExpr", "IntegerLiteral", "FloatingLiteral") and self.is_value(expression):
                for around in also_around.get(expression.type, []):
                    yield self.put("call added", expression, around.format(self.of(expression)))

    @staticmethod
    def put(kind, expression, text):
        return Mistake(kind, expression.begin, expression.end, f"({text})")

    def operator_of(self, expression):
        """The operator and its operands."""
        if expression.kind == "CXXOperatorCallExpr":
            name = self.text[expression.parts[0].begin:expression.parts[0].end] if expression.parts else ""
            operands = expression.parts[1:]
            if not re.fullmatch(r"[-+*/=!<>]+", name):
                return None, []
            # Clang has the operator first, wherever it stands
            return name, operands
        return expression.node["opcode"], expression.parts

    def of_operator(self, expression):
        op, operands = self.operator_of(expression)
        if op in ("-", "+") and len(operands) == 1:
            yield self.put("sign", expression, self.of(operands[0]))
        if len(operands) != 2:
            return
        a, b = (self.of(operand) for operand in operands)
        if op in arithmetic:
            yield self.put("left out", expression, a)
            if op != "/" or a != "1":
                yield self.put("left out", expression, {"/": f"1.0 / ({b})", "-": f"-({b})"}.get(op, b))
            if op in "-/":
                yield self.put("left out", expression, b)
                yield self.put("exchanged", expression, f"({b}) {op} ({a})")
            for other in arithmetic[op]:
                yield self.put("operator", expression, f"{a} {other} ({b})" if other in "/*-" else f"{a} {other} {b}")
            double = "2.0 * " if op in "+-" else f"{{}} {op} "
            for first, second in ((a, b), (b, a)) if op in "*" else ((a, b),):
                yield self.put("doubled", expression, f"({first}) {op} {double.format(f'({second})')}({second})")
            if operands[0].type == operands[1].type == "int" or (op == "/" and self.is_whole(operands[0]) and self.is_whole(operands[1])):
                yield self.put("integer division", expression, f"Real({a}) {op} ({b})")
                yield self.put("integer division", expression, f"int({a}) {op} int({b})")
            if op == "/" and operands[0].type == operands[1].type == "real":
                yield self.put("integer division", expression, f"int({a}) / int({b})" if b != "0" else a)
        if op in compared:
            for other in compared[op]:
                yield self.put("comparison", expression, f"{a} {other} {b}")
        if op in ("&&", "||"):
            yield self.put("left out", expression, a)
            yield self.put("left out", expression, b)
            yield self.put("operator", expression, f"({a}) {'&&' if op == '||' else '||'} ({b})")
        if op in ("+=", "-=", "*=", "/="):
            for other in ("=", "-=" if op == "+=" else "+=", "*=" if op[0] in "+-" else "+="):
                yield Mistake("operator", expression.begin, expression.end, f"{a} {other} {b}")

    @staticmethod
    def is_whole(expression):
        node = expression.node
        return type_of(node) == "int"

    def of_call(self, expression):
        if not expression.parts:
            return
        name = self.text[expression.parts[0].begin:expression.parts[0].end]
        arguments = expression.parts[1:]
        texts = [self.of(argument) for argument in arguments]
        for argument in arguments:
            if argument.type == expression.type:
                yield self.put("call left out", expression, self.of(argument))
        for other in exchanged.get(name.split(":")[-1], []):
            yield self.put("call exchanged", expression, f"{other}({', '.join(texts)})")
        if expression.kind == "CXXMemberCallExpr" and len(arguments) == 1 and arguments[0].type == expression.type:
            yield self.put("call left out", expression, texts[0])
        for i in range(len(arguments)) if name.split(":")[-1] not in ("dot", "min", "max", "distance") else []:
            for j in range(i + 1, len(arguments)):
                if arguments[i].type == arguments[j].type:
                    swapped = texts[:i] + [texts[j]] + texts[i + 1:j] + [texts[i]] + texts[j + 1:]
                    yield self.put("exchanged", expression, f"{name}({', '.join(swapped)})")

    def of_number(self, expression):
        text = self.of(expression)
        is_zero = re.fullmatch(r"0|0?\.0*f?", text)
        others = ["1", f"({text} + 1)", f"({text} - 1)"]
        if not is_zero:
            others += ["0", f"(2 * {text})", f"(0.5 * {text})", f"(-{text})"]
        if expression.type == "real" and not is_zero and text != "1":
            others.append(f"(1.0 / {text})")
        if expression.type == "real":
            others.append("pi")
        for other in others:
            yield Mistake("constant", expression.begin, expression.end, other)

    def of_list(self, expression):
        """Two elements of one type exchanged."""
        parts = [part for part in expression.parts if part.end > part.begin]
        for i, first in enumerate(parts):
            for second in parts[i + 1:]:
                if first.type == second.type and first.end <= second.begin:
                    text = self.of(second) + self.text[first.end:second.begin] + self.of(first)
                    yield Mistake("exchanged", first.begin, second.end, text)

    def of_any(self, expression):
        """Something put around it, and others of its type in its place."""
        text = self.of(expression)
        if expression.kind in ("InitListExpr", "LambdaExpr") or not self.is_value(expression) or self.is_nothing(text):
            return
        is_number = expression.kind in ("IntegerLiteral", "FloatingLiteral")
        if not is_number:
            for kind, all_ in put_around.get(expression.type, {}).items():
                for around in all_ if kind in ("sign", "branch") or not self.is_compared(expression) else []:
                    yield self.put(kind, expression, around.format(text))
        names = self.names_at(expression)
        if expression.is_name() and expression.kind == "MemberExpr" and re.search(r"\.[xyz]$", text):
            names = names + [text[:-1] + axis for axis in "xyz" if not (axis == "z" and self.is_flat(expression))]
        for name in dict.fromkeys(name for name in names if name != text):
            yield self.put("other expression", expression, name)
        if not expression.is_name() and not is_number:
            for constant in constants.get(expression.type, []) if not text.startswith(("Color(", "vec3(")) else []:
                yield self.put("other expression", expression, constant)
            for other in self.expressions:
                is_around = other.begin <= expression.begin and expression.end <= other.end
                near = abs(other.begin - expression.begin) < 120 and not is_around
                if near and other.type == expression.type and not other.is_name() and self.is_value(other) and other.end - other.begin < 60:
                    yield self.put("other expression", expression, self.of(other))

    @staticmethod
    def is_nothing(text):
        """Of which most changes are none: inf, or a vector of 0."""
        return text == "inf" or re.fullmatch(r"(rt::)?(Color|vec[23])\(0\)", text)

    @staticmethod
    def is_compared(expression):
        """With 0: of such a number only the sign matters."""
        parent = expression.parent
        while parent and parent.kind == "MemberExpr":
            parent = parent.parent
        return parent and parent.node.get("opcode") in compared and any(part.node.get("value") == "0" for part in parent.parts)

    @staticmethod
    def is_flat(expression):
        return expression.parts[0].type == "vec2"

    @staticmethod
    def is_value(expression):
        """Not a function, an operator, or the target of an assignment."""
        node, parent = expression.node, expression.parent
        if node.get("referencedDecl", {}).get("kind") in ("FunctionDecl", "CXXMethodDecl", "EnumConstantDecl"):
            return False
        if node.get("valueCategory") == "prvalue" and "void" == node.get("type", {}).get("qualType"):
            return False
        if parent and parent.kind == "CompoundAssignOperator" and parent.parts[0] is expression:
            return False
        if parent and parent.kind == "BinaryOperator" and parent.node["opcode"] == "=" and parent.parts[0] is expression:
            return False
        if parent and parent.kind == "UnaryOperator" and parent.node["opcode"] in ("++", "--"):
            return False
        if node["kind"] == "CompoundAssignOperator" or node.get("opcode") in ("=", "++", "--"):
            return False
        if node["kind"] == "CXXOperatorCallExpr" and node.get("valueCategory") == "lvalue":
            return False
        return expression.type in ("real", "int", "bool", "vec2", "vec3") or expression.is_name()

    def names_at(self, expression):
        """What is visible there of its type: arguments, their fields that are used, and variables; the nearest."""
        list_ = [name for name, type_ in self.parameters if type_ == expression.type]
        list_ += [name for end, name, type_ in reversed(self.locals) if end <= expression.begin and type_ == expression.type]
        for other in sorted(self.expressions, key=lambda other: abs(other.begin - expression.begin)):
            if other.kind == "MemberExpr" and other.is_name() and other.type == expression.type and self.is_value(other):
                list_.append(self.of(other))
        return [name for name in dict.fromkeys(list_) if name != self.of(expression)][:most_names]

    def of_statement(self, place, node):
        kind, inner = node["kind"], node.get("inner", [])
        if kind == "IfStmt":
            condition = self.range_of(inner[0])
            yield Mistake("branch", *condition, "true")
            yield Mistake("branch", *condition, "false")
        if kind in ("CompoundAssignOperator", "ContinueStmt", "CXXMemberCallExpr"):
            yield Mistake("left out", *place, "")
        if kind == "ForStmt":
            head = self.text[place[0]:place[1]].split(")")[0]
            begin = place[0] + head.find("= 0")
            if head.find("= 0") > 0:
                yield Mistake("loop", begin, begin + 3, "= 1")
            at = head.find("< ")
            if at > 0:
                yield Mistake("loop", place[0] + at, place[0] + at + 2, "< -1 + ")

