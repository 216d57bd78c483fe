# What every file that touches a number is compiled with: the same bits from every compiler and every way of building.
add_library(rt_numerics INTERFACE)
target_compile_features(rt_numerics INTERFACE cxx_std_20)
target_compile_options(rt_numerics INTERFACE -ffp-contract=off)

add_library(rt_warnings INTERFACE)
# Pragmas for one compiler are unknown to the other; members that an initialiser leaves out have defaults; and GCC 12 takes
# fmt's own loops, and copies of short strings, for overflows.
target_compile_options(rt_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wno-unknown-pragmas -Wno-missing-field-initializers
    $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds>)

# None of these changes a result.
add_library(rt_speed INTERFACE)
include(CheckCXXCompilerFlag)
foreach(flag -march=native -mprefer-vector-width=512)
    string(MAKE_C_IDENTIFIER "RT_HAS${flag}" has)
    check_cxx_compiler_flag(${flag} ${has})
    if(${has})
        target_compile_options(rt_speed INTERFACE $<$<CONFIG:Release>:${flag}>)
    endif()
endforeach()
target_compile_options(rt_speed INTERFACE $<$<CONFIG:Release>:-O3> -fno-math-errno -fno-trapping-math)

# A stage is one loop, and as fast as all that it calls is part of it.
# -fno-tree-sink: loads that sink into conditions are masked, and the lanes that a mask leaves out keep what was in the register;
# where that is denormal, each sum over it takes a hundred times as long.
add_library(rt_inlining INTERFACE)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(rt_inlining INTERFACE
        -fno-tree-sink -finline-limit=100000 --param=inline-unit-growth=10000 --param=large-function-growth=10000
        --param=large-stack-frame-growth=10000 --param=max-inline-insns-single=100000 --param=max-inline-insns-auto=100000)
else()
    target_compile_options(rt_inlining INTERFACE "SHELL:-mllvm -inline-threshold=100000")
endif()
