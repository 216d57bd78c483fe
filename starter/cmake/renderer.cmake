# compile_together(target group files...): these files of the target as one. Nearly all that a small file costs is the
# reading of the same headers.
function(compile_together target group)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${RT_TOGETHER} UNITY_BUILD_MODE GROUP)
    set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${group})
endfunction()

# add_framework(name speed): the library of all files of rt/, without fragments and without what only the program shows or
# exports.
#
# speed  the target whose options the stages are compiled with
function(add_framework name speed)
    get_filename_component(starter ${CMAKE_CURRENT_FUNCTION_LIST_DIR} DIRECTORY)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${starter}/rt/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/rt/(processor\\.cpp|show/|files/mitsuba)")
    add_library(${name} STATIC ${sources} $<TARGET_OBJECTS:${name}_processor>)
    target_include_directories(${name} PUBLIC ${starter})
    target_link_libraries(${name}
        PUBLIC rt_numerics glm::glm fmt::fmt TBB::tbb
        PRIVATE rt_warnings ${speed} OpenEXR::OpenEXR PNG::PNG tomlplusplus::tomlplusplus
                $<IF:$<TARGET_EXISTS:tinyobjloader::tinyobjloader_double>,tinyobjloader::tinyobjloader_double,tinyobjloader::tinyobjloader>)

    target_precompile_headers(${name} PRIVATE ${starter}/rt/scene.h <algorithm> <string> <vector> <fmt/format.h>)

    # Not the stages: each is compiled for its one loop. Not images: the grader's renderers are linked without the libraries
    # that read and write them. Not the tables: they make assertions of toml++ throw. The plan is apart from
    # the rendering: a program that only plans needs no fragments.
    file(GLOB_RECURSE others RELATIVE ${starter}/rt ${starter}/rt/*.cpp)
    list(FILTER others EXCLUDE REGEX "^(stages/|show/|files/(image|mitsuba|toml_table)|not_started|processor)")
    set(rooms files trace plan rendering)
    set(expressions "^files/" "^trace" "^(calls|plan|lamps/.*|media/bodies)\\." ".")
    foreach(room expression IN ZIP_LISTS rooms expressions)
        set(of_room ${others})
        list(FILTER of_room INCLUDE REGEX "${expression}")
        list(REMOVE_ITEM others ${of_room})
        list(TRANSFORM of_room PREPEND ${starter}/rt/)
        compile_together(${name} rt_${room} ${of_room})
    endforeach()
    # The one file that runs on any processor; no sanitizer has begun when it does.
    get_target_property(built_for ${speed} RT_BUILT_FOR)
    add_library(${name}_processor OBJECT ${starter}/rt/processor.cpp)
    target_include_directories(${name}_processor PRIVATE ${starter})
    target_compile_definitions(${name}_processor PRIVATE RT_BUILT_FOR="${built_for}")
    target_compile_options(${name}_processor PRIVATE -fno-sanitize=all)
    target_link_libraries(${name}_processor PRIVATE rt_numerics rt_warnings)
    set_target_properties(${name} PROPERTIES RT_BUILT_FOR "${built_for}")
endfunction()

# add_fragments(name folder): the fragments of a folder, an object of its own for each.
function(add_fragments name folder)
    file(GLOB fragments CONFIGURE_DEPENDS ${folder}/*.cpp)
    if(NOT fragments)
        message(FATAL_ERROR "${folder}: no fragments here; expected a folder with one .cpp file for each")
    endif()
    add_library(${name} OBJECT ${fragments})
    target_link_libraries(${name} PRIVATE rt rt_speed rt_warnings rt_blanks)
    precompile_fragments_header(${name} rt rt_speed)
endfunction()

# precompile_fragments_header(name rt speed): what every fragment includes, compiled once for all sets of fragments with
# these options, for a target of its own: CMake counts it among that target's objects.
function(precompile_fragments_header name rt speed)
    set(header fragments_header_${rt})
    if(NOT TARGET ${header})
        set(source ${CMAKE_CURRENT_BINARY_DIR}/${header}.cpp)
        file(CONFIGURE OUTPUT ${source} CONTENT "// What fragments include, compiled in advance.\n")
        add_library(${header} OBJECT ${source})
        target_link_libraries(${header} PRIVATE ${rt} ${speed} rt_warnings)
        target_precompile_headers(${header} PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../rt/fragments.h)
    endif()
    target_precompile_headers(${name} REUSE_FROM ${header})
endfunction()

# add_renderer(name fragments [LINKED]): the program `name`, with the target that add_fragments has made.
#
# Unless LINKED, the fragments are also included, as inline functions, into one file with the stages, which then call
# nothing; where that file does not compile, since helpers of two fragments share a name, say, the program falls back on
# the objects.
function(add_renderer name fragments)
    cmake_parse_arguments(PARSE_ARGV 2 arg "LINKED" "" "")
    add_executable(${name} $<TARGET_OBJECTS:raytrace_main> $<TARGET_OBJECTS:raytrace_parts> $<TARGET_OBJECTS:${fragments}>)
    target_link_libraries(${name} PRIVATE rt)
    if(NOT arg_LINKED)
        get_target_property(sources ${fragments} SOURCES)
        add_inlined_stages(${name}_inlined "${sources}")
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
    file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../rt/*.h)
    set(includes ${fragments} ${stages})
    list(TRANSFORM includes REPLACE "(.+)" "#include \"\\1\"")
    list(JOIN includes "\n" includes)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    configure_file(${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../cmake/inlined.cpp.in ${source} @ONLY)

    add_library(${name} OBJECT ${source})
    target_link_libraries(${name} PRIVATE rt rt_speed rt_inlining)
    set_target_properties(${name} PROPERTIES CXX_COMPILER_LAUNCHER "sh;${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../cmake/inline_or_link")
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS -w OBJECT_DEPENDS "${fragments};${stages};${headers}")
endfunction()
