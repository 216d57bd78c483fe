"""Symbols, objects and sections that the linker reads."""

import struct
import subprocess

from .kit import case, disk, victim_is_whole

case("7", "its own main", {"passed", "did_not_build"}, own=True,
     source=disk("    return right(u);", 'int main() { std::puts("passed"); return 0; }\nextern "C" void _start() { _exit(0); }'))


@case("8", "objects, caches and precompiled headers beside the source", "failed")
def _(place):
    junk = b"gpch.014" + bytes(1000)
    return {"fragments/uniform_disk.cpp": disk("    return wrong(u);"), "fragments/uniform_disk.o": b"\x7fELF" + bytes(500),
            "fragments/rt/fragments.h.gch": junk, "build/release/kept/uniform_disk": junk, "build/CMakeCache.txt": "X=1\n",
            "last_run.json": "{}", "fragments/libm.so.6": junk}


case("33a", "overrides the C library", "passed", own=True,
     source=disk("    return right(u);", """
extern "C" {
void* malloc(std::size_t) { std::abort(); }
void free(void*) { std::abort(); }
ssize_t write(int, const void*, std::size_t) { std::abort(); }
ssize_t read(int, void*, std::size_t) { std::abort(); }
int clock_gettime(clockid_t, timespec* t) { t->tv_sec = t->tv_nsec = 0; return 0; }
void __asan_init() { std::abort(); }
const char* __asan_default_options() { return "detect_leaks=0"; }
}
void* operator new(std::size_t) { std::abort(); }
void operator delete(void*) noexcept { std::abort(); }"""))

case("33b", "overrides of the grader's own functions", "passed",
     source=disk("    return right(u);", """
namespace rt { void require_processor() { std::abort(); } Color pixel_mean(std::span<const Color>, std::span<const Real>) { std::abort(); } }
namespace grade { std::vector<double> probe(const std::string&, const std::vector<double>&) { std::abort(); } }"""))


def lto_sections(place, source, options=None):
    """asm that puts the sections of a bytecode object into a fragment."""
    work = place.folder / "lto"
    work.mkdir(exist_ok=True)
    (work / "m.cpp").write_text(source)
    chain = place.chain
    includes = [word for folder in chain["includes"] for word in ("-I", folder)]
    subprocess.run([chain["compiler"], *chain["compile"], *chain["options"], *includes, "-w", "-flto", "-fno-fat-lto-objects", "-c", "m.cpp"],
                   cwd=work, check=True)
    data = (work / "m.o").read_bytes()
    table, = struct.unpack_from("<Q", data, 40)
    count, names = struct.unpack_from("<HH", data, 60)
    headers = [struct.unpack_from("<IIQQQQIIQQ", data, table + 64 * i) for i in range(count)]
    lines = ['asm(R"(']
    for header in headers:
        at = headers[names][4] + header[0]
        name = data[at:data.index(b"\0", at)].decode()
        if not name.startswith(".gnu.lto_"):
            continue
        content = data[header[4]:header[4] + header[5]]
        if options and name.startswith(".gnu.lto_.opts"):
            content = options.encode() + b"\0"
        lines.append(f'.section {name},"e",@progbits')
        lines += [".byte " + ",".join(map(str, content[i:i + 64])) for i in range(0, len(content), 64)]
    return "\n".join(lines + [".text", ')");\n'])


@case("36a", "an LTO object through asm, with the right answer in it", {"did_not_build", "failed"})
def _(place):
    return disk("    return wrong(u);") + lto_sections(place, disk("    return right(u);"))


@case("36b", "an LTO object that includes the solution and its object", {"did_not_build", "failed"})
def _(place):
    solution = place.chain.get("solution_objects", ["/none"])
    disk_object = next((name for name in solution if "uniform_disk" in name), "/none")
    extra = "\n".join(f'asm(".incbin \\"{path}\\"");' for path in (place.secret, place.root / "solution/uniform_disk.cpp", disk_object))
    return disk("    return wrong(u);") + lto_sections(place, disk("    return right(u);", extra))


@case("36c", "an LTO object with options that write files", {"did_not_build", "failed"}, after=victim_is_whole)
def _(place):
    options = " ".join(f"'{word}'" for word in ("-O2", "-dumpdir", f"{place.victim}/", "-fdump-tree-all", f"-Wa,-adhln={place.victim}/list", "-save-temps",
                                                "-B", str(place.victim), "-fplugin=/none.so"))
    return disk("    return wrong(u);") + lto_sections(place, disk("    return right(u);", 'asm(".print \\"taken\\"");'), options)


@case("36d", "an object that asks for a plugin, a script and libraries", {"did_not_build", "failed", "passed"})
def _(place):
    return disk("    return right(u);", f'''
asm(R"(.section .deplibs,"MS",@0x6fff4c04,1
.asciz "{place.victim}/lib.so"
.section .note.GNU-stack,"x",@progbits
.section .interp,"a",@progbits
.asciz "{place.victim}/ld.so"
.section .preinit_array,"aw",@preinit_array
.text
)");''')
