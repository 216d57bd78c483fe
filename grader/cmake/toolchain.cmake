# write_toolchain(file child rt blanks solution speed libraries): how the grader compiles and links, for itself or for a
# kit; see toolchain.toml.in.
#
# speed      the target whose options its fragments are compiled with, beside those of the framework
# libraries  a list: what the framework is linked with
function(write_toolchain file child rt blanks solution libraries)
    string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
    separate_arguments(compile UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}}")
    separate_arguments(link UNIX_COMMAND "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${CMAKE_EXE_LINKER_FLAGS}")
    list(APPEND compile ${CMAKE_CXX20_EXTENSION_COMPILE_OPTION})
    foreach(list compile link libraries)
        list(JOIN ${list} "\", \"" text)
        set(${list} "[\"${text}\"]")
    endforeach()
    set(commit "${PENUMBRA_COMMIT}")
    set(gcc false)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        set(gcc true)
    endif()
    get_target_property(built_for ${rt} RT_BUILT_FOR)
    configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/toolchain.toml.in ${file}.in @ONLY)
    file(GENERATE OUTPUT ${file} INPUT ${file}.in)
endfunction()
