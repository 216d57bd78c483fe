# add_renderer(name FRAGMENTS folder [LINKED]): the program `name`, with the fragments of a folder.
#
# Each fragment is an object of its own. Unless LINKED, the fragments are also included, as inline functions, into one
# file with the stages, which then call nothing; where that file does not compile, since helpers of two fragments share
# a name, say, the program falls back on the objects.
function(add_renderer name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "LINKED" "FRAGMENTS" "")
    file(GLOB fragments CONFIGURE_DEPENDS ${arg_FRAGMENTS}/*.cpp)
    if(NOT fragments)
        message(FATAL_ERROR "${arg_FRAGMENTS}: no fragments here; expected a folder with one .cpp file for each")
    endif()

    add_library(${name}_fragments OBJECT ${fragments})
    target_compile_options(${name}_fragments PRIVATE -Wno-unused-parameter)  # a blank uses none of its parameters
    target_link_libraries(${name}_fragments PRIVATE rt rt_speed rt_warnings)

    add_executable(${name} $<TARGET_OBJECTS:raytrace_main> $<TARGET_OBJECTS:${name}_fragments>)
    target_link_libraries(${name} PRIVATE rt)
    if(NOT arg_LINKED)
        add_inlined_stages(${name}_inlined "${fragments}")
        target_sources(${name} PRIVATE $<TARGET_OBJECTS:${name}_inlined>)
    endif()
endfunction()

# add_inlined_stages(name fragments): an object file that takes the place of the framework's stages.
function(add_inlined_stages name fragments)
    set(declarations "")
    # one declaration a line; inline, so that the objects' definitions may stand beside these, and always, for a loop
    # with a call in it is not vectorised
    file(STRINGS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../rt/fragments.h lines REGEX "^[A-Za-z].*\\(.*\\);$")
    foreach(line IN LISTS lines)
        if(NOT line MATCHES "report_not_started")
            string(APPEND declarations "[[gnu::always_inline]] inline ${line}\n")
        endif()
    endforeach()
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../rt/fragments.h)

    file(GLOB stages CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../rt/stages/*.cpp)
    set(includes ${fragments} ${stages})
    list(TRANSFORM includes REPLACE "(.+)" "#include \"\\1\"")
    list(JOIN includes "\n" includes)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../cmake/inlined.cpp.in ${source} @ONLY)

    add_library(${name} OBJECT ${source})
    target_link_libraries(${name} PRIVATE rt rt_speed rt_inlining)
    set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "sh;${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../cmake/inline_or_link")
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -w OBJECT_DEPENDS "${fragments};${stages}")
endfunction()
