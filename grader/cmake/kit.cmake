# What `grade hand-out` hands out, built for the oldest processors of this kind: the grader, the framework, the reference
# fragments and the blanks. The target is grade_kit; ./grade hand-out builds it.
add_speed(rt_baseline_speed x86-64-v2)
add_framework(rt_baseline rt_baseline_speed)
add_child(child_baseline rt_baseline)

add_library(solution_baseline OBJECT ${solution_sources})
add_library(blanks_baseline OBJECT ${blank_sources})
add_dependencies(blanks_baseline blank_sources)
# A blank tells its file: as a student knows it, not where it was built.
set_source_files_properties(${blank_sources} PROPERTIES COMPILE_OPTIONS -fmacro-prefix-map=${blanks_folder}=starter/fragments)
foreach(objects solution_baseline blanks_baseline)
    target_link_libraries(${objects} PRIVATE rt_baseline rt_baseline_speed)
    precompile_fragments_header(${objects} rt_baseline rt_baseline_speed)
endforeach()

# add_kit_grade(name archives): the same of these parts. Its libraries are beside it; old-style, so that theirs are found
# there too. Without symbols: half of its size.
function(add_kit_grade name archives)
    add_grade(${name} rt_baseline rt_baseline_speed ${archives} child_baseline solution_baseline blanks_baseline)
    add_dependencies(${name} ${name}_studies)
    foreach(program ${name} ${name}_studies)
        target_link_options(${program} PRIVATE -Wl,--disable-new-dtags -Wl,--gc-sections -Wl,-s)
        set_target_properties(${program} PROPERTIES BUILD_WITH_INSTALL_RPATH ON INSTALL_RPATH "$ORIGIN/lib")
    endforeach()
    set_target_properties(${name}_here ${name} ${name}_studies PROPERTIES EXCLUDE_FROM_ALL ON)
endfunction()
add_kit_grade(grade_kit kit)

# The renderer of these parts: its pictures have the same bits.
add_executable(raytrace_baseline $<TARGET_OBJECTS:raytrace_main> $<TARGET_OBJECTS:raytrace_parts> $<TARGET_OBJECTS:solution_baseline>)
target_link_libraries(raytrace_baseline PRIVATE rt_baseline)

set_target_properties(raytrace_baseline rt_baseline rt_baseline_processor child_baseline fragments_header_rt_baseline solution_baseline
    blanks_baseline blank_sources PROPERTIES EXCLUDE_FROM_ALL ON)
write_toolchain(${PROJECT_BINARY_DIR}/kit.toml child_baseline rt_baseline blanks_baseline solution_baseline "${libraries}")
