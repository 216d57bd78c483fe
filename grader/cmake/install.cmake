# cmake --install and cpack: PREFIX/bin/grade, and below PREFIX/lib/penumbra a kit that reads archives as well. Nobody
# writes there: what a run leaves for the next is in each user's own cache. For a PREFIX in /usr the kit is below
# /opt/penumbra: submissions read what is in /usr, and Landlock cannot hide a part of it.

add_kit_grade(grade_installed archives)
add_dependencies(grade_installed grade)

# By the program that writes kits. Whatever the umask is, everybody may read it.
install(CODE "
    set(prefix \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}\")
    set(folder \"\${prefix}/lib/penumbra\")
    if(\"\${CMAKE_INSTALL_PREFIX}/\" MATCHES \"^/usr/\")
        set(folder \"\$ENV{DESTDIR}/opt/penumbra\")
    endif()
    execute_process(COMMAND \"${CMAKE_COMMAND}\" --build \"${PROJECT_BINARY_DIR}\" --target grade_installed
        COMMAND_ERROR_IS_FATAL ANY)
    if(EXISTS \"\${folder}/grader/blanks\")
        file(REMOVE_RECURSE \"\${folder}\")  # what was installed before
    endif()
    get_filename_component(above \"\${folder}\" DIRECTORY)
    foreach(place \"\${prefix}\" \"\${above}\" \"\${prefix}/bin\")
        if(NOT EXISTS \"\${place}\")
            file(MAKE_DIRECTORY \"\${place}\")
            execute_process(COMMAND chmod 755 \"\${place}\" COMMAND_ERROR_IS_FATAL ANY)
        endif()
    endforeach()
    execute_process(COMMAND \"$<TARGET_FILE:grade>\" hand-out --installed \"\${folder}\" COMMAND_ERROR_IS_FATAL ANY)
    execute_process(COMMAND chmod -R u=rwX,go=rX \"\${folder}\" COMMAND_ERROR_IS_FATAL ANY)
    file(RELATIVE_PATH target \"\${prefix}/bin\" \"\${folder}/grade\")
    file(CREATE_LINK \"\${target}\" \"\${prefix}/bin/grade\" SYMBOLIC)")
set(CMAKE_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE
    GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/penumbra RENAME copyright)

execute_process(COMMAND getconf GNU_LIBC_VERSION OUTPUT_VARIABLE libc OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
string(REGEX REPLACE "^glibc " "" libc "${libc}")
string(REGEX MATCH "^[0-9]+" compiler "${CMAKE_CXX_COMPILER_VERSION}")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "whoever built it")
set(CPACK_SET_DESTDIR ON)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION education)
string(JOIN ", " CPACK_DEBIAN_PACKAGE_DEPENDS "libc6 (>= ${libc})" "libstdc++6 (>= ${compiler})" zlib1g
    "libarchive13 | libarchive13t64" g++ binutils bubblewrap)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS mold)
set(CPACK_STRIP_FILES OFF)  # the objects of fragments are as they must be
include(CPack)
