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

# After the warnings, for the order counts: a blank uses none of its parameters.
add_library(rt_blanks INTERFACE)
target_compile_options(rt_blanks INTERFACE -Wno-unused-parameter)

# The processors that the code is made for:
#
#     native       this one, by the best of the kinds below that it is of
#     x86-64-v2    all since 2009; what a kit is built for
#     x86-64-v3    with AVX2, since 2013 (Intel) and 2015 (AMD): clusters and images whose machines differ
#     x86-64-v4    with AVX-512
#
# Pictures have the same bits with all of them. A program that is started on a lesser processor says so (rt/processor.cpp), and
# ./grade builds again there. On other processors than x86-64 native stands for what they all have, and what else is given
# goes to the compiler as it is.
set(RT_MARCH native CACHE STRING "The processors to build for: native, x86-64-v2, x86-64-v3, x86-64-v4")
set_property(CACHE RT_MARCH PROPERTY STRINGS native x86-64-v2 x86-64-v3 x86-64-v4)

# What each kind adds to the one before, by the names of /proc/cpuinfo.
set(instructions_of_x86-64-v2 pni ssse3 sse4_1 sse4_2 popcnt)
set(instructions_of_x86-64-v3 avx avx2 bmi1 bmi2 f16c fma abm movbe)
set(instructions_of_x86-64-v4 avx512f avx512bw avx512cd avx512dq avx512vl)

# kind_of_processor(result): the best kind that this processor is of, by the compiler's account.
function(kind_of_processor result)
    execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -dM -E -x c++ /dev/null OUTPUT_VARIABLE macros ERROR_QUIET)
    set(best x86-64)
    foreach(kind x86-64-v2 x86-64-v3 x86-64-v4)
        string(TOUPPER "${instructions_of_${kind}}" names)
        string(REPLACE "PNI" "SSE3" names "${names}")
        string(REPLACE "BMI1" "BMI" names "${names}")
        string(REPLACE "ABM" "LZCNT" names "${names}")
        foreach(name IN LISTS names)
            if(NOT macros MATCHES "#define __${name}__ ")
                set(${result} ${best} PARENT_SCOPE)
                return()
            endif()
        endforeach()
        set(best ${kind})
    endforeach()
    set(${result} ${best} PARENT_SCOPE)
endfunction()

# add_speed(name march): the options that make code fast, on the processors that RT_MARCH may name. None changes a result.
# The kind itself is the target's property RT_BUILT_FOR; "": any.
function(add_speed name march)
    add_library(${name} INTERFACE)
    set(kind "")
    set(flags "")
    if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|amd64|AMD64)$")
        set(kind ${march})
        if(march STREQUAL "native")
            kind_of_processor(kind)
            set(flags -mtune=native)
        endif()
        if(NOT kind MATCHES "^x86-64(-v[234])?$")
            message(FATAL_ERROR "RT_MARCH: ${march} is no kind of processor; expected native, x86-64-v2, x86-64-v3 or x86-64-v4")
        endif()
        list(PREPEND flags -march=${kind})
        if(kind STREQUAL "x86-64-v4")
            list(APPEND flags -mprefer-vector-width=512)
        endif()
    elseif(NOT march MATCHES "^native$|^x86-64")
        set(flags -march=${march})
    endif()
    foreach(flag IN LISTS flags)
        target_compile_options(${name} INTERFACE $<$<CONFIG:Release>:${flag}>)
    endforeach()
    target_compile_options(${name} INTERFACE $<$<CONFIG:Release>:-O3> -fno-math-errno -fno-trapping-math)
    set_target_properties(${name} PROPERTIES RT_BUILT_FOR "$<$<CONFIG:Release>:${kind}>")
endfunction()
add_speed(rt_speed ${RT_MARCH})

# What the programs of this folder need of a processor, for the script that builds them.
get_target_property(kind rt_speed RT_BUILT_FOR)
set(needed "")
set(all "")
foreach(step x86-64-v2 x86-64-v3 x86-64-v4)
    list(APPEND all ${instructions_of_${step}})
    if(kind MATCHES ${step})
        set(needed ${all})
    endif()
endforeach()
list(JOIN needed " " needed)
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/instructions CONTENT "$<$<CONFIG:Release>:${needed}>\n")

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
