# PENUMBRA_COMMIT: what is checked out, for the record of a grading; empty where this is no repository of its own.
set(PENUMBRA_COMMIT "")
if(EXISTS ${PROJECT_SOURCE_DIR}/.git)
    find_program(GIT git)
    mark_as_advanced(GIT)
endif()
if(EXISTS ${PROJECT_SOURCE_DIR}/.git AND GIT)
    execute_process(COMMAND ${GIT} -C ${PROJECT_SOURCE_DIR} rev-parse HEAD
        OUTPUT_VARIABLE PENUMBRA_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    execute_process(COMMAND ${GIT} -C ${PROJECT_SOURCE_DIR} rev-parse --git-path logs/HEAD
        OUTPUT_VARIABLE log OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    # each commit adds a line to it
    get_filename_component(log "${log}" ABSOLUTE BASE_DIR ${PROJECT_SOURCE_DIR})
    if(EXISTS ${log} AND NOT IS_DIRECTORY ${log})
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${log})
    endif()
endif()
