#include "rt/processor.h"

#include <unistd.h>

#include <cstring>
#ifdef __x86_64__
#include <cpuid.h>
#endif

// This file is compiled for any processor, and calls no inline function of a library: the linker may have taken that
// from a file which is not.

namespace rt {

namespace {

#ifdef __x86_64__

/// What the processor has, and the system keeps for each program.
struct Instructions {
    unsigned a = 0, b = 0;             // leaf 1 in ecx, leaf 7 in ebx
    unsigned extended = 0;             // leaf 0x80000001 in ecx
    unsigned long long registers = 0;  // xgetbv
};

Instructions instructions() {
    Instructions found;
    unsigned eax = 0, ebx = 0, ecx = 0, edx = 0;
    __get_cpuid(1, &eax, &ebx, &found.a, &edx);
    __get_cpuid_count(7, 0, &eax, &found.b, &ecx, &edx);
    __get_cpuid(0x80000001, &eax, &ebx, &found.extended, &edx);
    if (found.a & bit_OSXSAVE) {
        __asm__("xgetbv" : "=a"(eax), "=d"(edx) : "c"(0));
        found.registers = (static_cast<unsigned long long>(edx) << 32) | eax;
    }
    return found;
}

constexpr bool all(unsigned long long there, unsigned long long wanted) { return (there & wanted) == wanted; }

#endif

void say(const char* text) {
    if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

/// Before the initialisers of any library.
#ifdef __linux__
[[gnu::used, gnu::section(".preinit_array")]] void (*const first_of_all)() = require_processor;
#endif

}  // namespace

bool processor_is(const char* kind) {
    if (kind[0] == '\0') return true;
#ifdef __x86_64__
    const Instructions found = instructions();
    const bool v2 = all(found.a, bit_SSE3 | bit_SSSE3 | bit_SSE4_1 | bit_SSE4_2 | bit_POPCNT);
    const bool v3 = v2 && all(found.a, bit_FMA | bit_MOVBE | bit_AVX | bit_F16C) &&
                    all(found.b, bit_BMI | bit_AVX2 | bit_BMI2) && all(found.extended, bit_LZCNT) &&
                    all(found.registers, 0x06);
    const bool v4 = v3 && all(found.b, bit_AVX512F | bit_AVX512DQ | bit_AVX512CD | bit_AVX512BW | bit_AVX512VL) &&
                    all(found.registers, 0xe6);
    if (std::strcmp(kind, "x86-64-v2") == 0) return v2;
    if (std::strcmp(kind, "x86-64-v3") == 0) return v3;
    if (std::strcmp(kind, "x86-64-v4") == 0) return v4;
#endif
    return true;
}

void require_processor() {
    if (processor_is(RT_BUILT_FOR)) return;
    say("This program is built for " RT_BUILT_FOR
        " processors, and this one is none. Build it again on this machine, as ./grade "
        "does, or for more of them: cmake -DRT_MARCH=x86-64-v2; see starter/cmake/flags.cmake.\n");
    _exit(3);
}

}  // namespace rt
