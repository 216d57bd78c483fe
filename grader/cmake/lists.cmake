# The lists of fragments, made from starter/rt/fragments.h, assignment.toml and the files of checks/.

# expect_in(names others message): an error for each of the names that is not among the others; in the message, NAME
# stands for it. Indented, since CMake breaks other lines.
function(expect_in names others message)
    set(missing ${${names}})
    list(REMOVE_ITEM missing ${${others}})
    foreach(name IN LISTS missing)
        string(REPLACE "NAME" ${name} text "${message}")
        message(SEND_ERROR "  ${text}")
    endforeach()
endfunction()

# make_lists(folder): writes there
#
#     checks/fragment_checks.h   the checks, in the order of the assignment; then those of fragments that it leaves out
#     child/each_fragment.h      the fragments, as functions
#     protocol/width.cpp         how many numbers each answers with
#     checks/scene_texts.cpp     the scenes beside the checks, as texts
#     asked/NAME.h               the declaration of each, and that of its checks
function(make_lists folder)
    set(header ${PROJECT_SOURCE_DIR}/starter/rt/fragments.h)
    set(assignment ${PROJECT_SOURCE_DIR}/assignment.toml)
    # as add_renderer has it for the header
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${assignment})

    # one declaration a line
    file(STRINGS ${header} lines REGEX "^[A-Za-z].*\\(.*\\);$")
    foreach(declaration IN LISTS lines)
        string(REGEX REPLACE "^[^(]* ([A-Za-z0-9_]+)\\(.*" "\\1" name "${declaration}")
        if(NOT name STREQUAL "report_not_started")
            list(APPEND declared ${name})
            configure_file(checks/asked.h.in ${folder}/asked/${name}.h @ONLY)
        endif()
    endforeach()

    # { name = "phong", points = 3 }, and no comment
    file(READ ${assignment} text)
    string(REGEX REPLACE "#[^\n]*" "" text "${text}")
    string(REGEX MATCHALL "{[^}]*name *= *\"[A-Za-z0-9_]+\"" assigned "${text}")
    list(TRANSFORM assigned REPLACE ".*\"([A-Za-z0-9_]+)\"$" "\\1")
    # what is declared nowhere is told by who reads the assignment: strip_solution, with line and column
    set(undeclared ${assigned})
    list(REMOVE_ITEM undeclared ${declared})
    list(REMOVE_ITEM assigned "" ${undeclared})

    file(GLOB checked RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/checks CONFIGURE_DEPENDS checks/*.cpp)
    list(TRANSFORM checked REPLACE "\\.cpp$" "")

    file(GLOB solved RELATIVE ${PROJECT_SOURCE_DIR}/solution CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/solution/*.cpp)
    list(TRANSFORM solved REPLACE "\\.cpp$" "")
    expect_in(declared solved
        "solution/NAME.cpp: is missing; expected the solution of the fragment NAME of fragments.h, with its markers")
    expect_in(solved declared
        "solution/NAME.cpp: no fragment is named NAME; expected one that starter/rt/fragments.h declares")
    expect_in(declared checked
        "grader/checks/NAME.cpp: is missing; expected the checks of the fragment NAME of fragments.h")
    expect_in(checked declared
        "grader/checks/NAME.cpp: no fragment is named NAME; expected one of fragments.h, or the file in checks/kit")

    # what a course leaves out is handed out filled in
    set(others ${declared})
    list(REMOVE_ITEM others ${assigned})
    foreach(name IN LISTS others)
        message(STATUS "assignment.toml leaves ${name} out: handed out filled in, not graded")
    endforeach()

    foreach(name IN LISTS assigned others)
        string(APPEND functions "Checks check_${name}(Generator& random);\n")
        string(APPEND entries "    {\"${name}\", check_${name}},\n")
        string(APPEND visits "    visit(\"${name}\", rt::${name});\n")
        string(APPEND widths "        {\"${name}\", Width<decltype(rt::${name})>::value()},\n")
    endforeach()
    configure_file(checks/fragment_checks.h.in ${folder}/checks/fragment_checks.h @ONLY)
    configure_file(child/each_fragment.h.in ${folder}/child/each_fragment.h @ONLY)
    configure_file(protocol/width.cpp.in ${folder}/protocol/width.cpp @ONLY)

    file(GLOB scenes RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/checks CONFIGURE_DEPENDS checks/*.toml)
    list(LENGTH scenes count)
    set(texts "")
    foreach(scene IN LISTS scenes)
        file(READ checks/${scene} text)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS checks/${scene})
        string(APPEND texts "        {\"${scene}\", R\"toml(${text})toml\"},\n")
    endforeach()
    configure_file(checks/scene_texts.cpp.in ${folder}/checks/scene_texts.cpp @ONLY)
endfunction()
