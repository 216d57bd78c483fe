"""What costs the compiler and the demangler too much."""

from .kit import NO_BUG, case, disk

COMPILER = ("the compiler", "compiler ran", "compiling", "too ", "exceeds", "limit", "memory")

case("9a", "templates without end", "did_not_build", COMPILER, absent=NO_BUG, seconds=180, bystander=True,
     source=disk("    return right(u), DiskSample{vec2(Tree<40, 0>::value), 1};", """
template <int depth, unsigned long n> struct Tree {
    static constexpr unsigned long value = Tree<depth - 1, 2 * n>::value + Tree<depth - 1, 2 * n + 1>::value;
};
template <unsigned long n> struct Tree<0, n> { static constexpr unsigned long value = n; };"""))

case("9b", "a constexpr loop without end", "did_not_build", COMPILER + ("constexpr",), absent=NO_BUG, seconds=180,
     source=disk("    return {vec2(forever()), 1};", "consteval int forever() { int n = 0; for (unsigned i = 1; i; i |= 1) n += 1; return n; }"))

case("9c", "an initialised array of 2 GB", "did_not_build", COMPILER + ("large",), absent=NO_BUG, seconds=180,
     source=disk("    return data[int(u.x)] ? right(u) : wrong(u);", "static volatile char data[1 << 30] = {1};\nstatic volatile char more[1 << 30] = {1};"))

case("9d", "an array of zeros of 1 TB", {"did_not_build", "crashed"}, COMPILER + ("large", "truncated", "relocation"), absent=NO_BUG + ("must return, not exit",), seconds=180,
     source=disk("    return data[long(u.x * 1e9)] ? wrong(u) : right(u);", "static volatile char data[1l << 40];"))

case("9e", "brackets 200,000 deep", "did_not_build", COMPILER + ("nesting",), absent=NO_BUG, seconds=180,
     source=disk("    return {vec2(" + "(" * 100_000 + "0" + ")" * 100_000 + "), 1};"))


def exploding(depth):
    """A symbol of some hundred characters that demangles to 2^depth names."""
    digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"
    def sub(i):  # substitution number i
        if i == 0:
            return "S_"
        i -= 1
        return "S" + ((digits[i // 36] if i >= 36 else "") + digits[i % 36]) + "_"
    name = "_Z12uniform_diskSt4pairIiiE"
    for level in range(depth):
        name += f"S_I{sub(level + 1)}{sub(level + 1)}E"
    return name

case("37a", "a symbol that demangles to gigabytes, for its own name", "did_not_build", fast=True,
     source=f'#include "rt/fragments.h"\nextern "C" void boom() asm("{exploding(56)}");\nextern "C" void boom() {{}}\n')

MANY = exploding(24)

case("37b", "500 such symbols beside the right one", {"passed", "did_not_build"},
     source=disk("    return right(u);") + "".join(
         f'extern "C" void boom{i}() asm("{MANY}{"i" * (i % 97)}_{i}");\nextern "C" void boom{i}() {{}}\n' for i in range(500)))


case("37c", "an undefined symbol that demangles to gigabytes", "did_not_build",
     source=disk("    boom();\n    return right(u);", f'extern "C" void boom() asm("{exploding(56)}");'))

case("39b", "400 MB in the object", "did_not_build", ("the compiler", "large", "MB", "too", "assembler"), bystander=True, absent=NO_BUG,
     source=disk("    return right(u);", 'asm(".data\\n.fill 400000000\\n.text");'))
