# SPDX-License-Identifier: GPL-3.0-or-later
# What is made of the programs' tables of options, in the build as it will be installed, share/ beside bin/: manual pages,
# and completion for bash, which asks the programs themselves. Of the levels of a package one makes them, that which any
# processor can run.
get_property(programs GLOBAL PROPERTY SLOSH_PROGRAMS)
get_property(scripts GLOBAL PROPERTY SLOSH_SCRIPTS)
if(NOT SLOSH_LEVEL OR SLOSH_LEVEL STREQUAL "x86-64")
    set(man ${PROJECT_BINARY_DIR}/share/man/man1)
    file(MAKE_DIRECTORY ${man})
    foreach(program ${programs} ${scripts})
        set(file ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/${program})
        add_custom_command(OUTPUT ${man}/${program}.1 COMMAND ${file} -help-man > ${man}/${program}.1
                           DEPENDS $<IF:$<TARGET_EXISTS:${program}>,${program},${file}> COMMENT "Writing the manual page ${program}.1" VERBATIM)
        list(APPEND manPages ${man}/${program}.1)
    endforeach()
    add_custom_target(manPages ALL DEPENDS ${manPages})
    add_dependencies(programs manPages)
    install(FILES ${manPages} DESTINATION share/man/man1)

    set(completions ${PROJECT_BINARY_DIR}/share/bash-completion/completions)
    list(JOIN programs " " SLOSH_PROGRAMS)
    string(APPEND SLOSH_PROGRAMS " ${scripts}")
    configure_file(etc/completion.bash.in ${completions}/sloshsph @ONLY)
    foreach(program ${programs} ${scripts})
        file(CREATE_LINK sloshsph ${completions}/${program} SYMBOLIC) # by this name it is looked for
    endforeach()
    install(DIRECTORY ${completions}/ DESTINATION share/bash-completion/completions)
endif()
