# SPDX-License-Identifier: GPL-3.0-or-later
# What `cmake --install` puts where: programs to bin/, dictionaries, tutorials and scripts to share/sloshsph/, in the same
# folders as here, documents to share/doc/sloshsph/. For a level of the instruction set (SLOSH_LEVEL) programs go to
# lib/sloshsph/<level>/, and bin/ has links to chooseLevel, which starts those of the level that the processor has.
get_property(programs GLOBAL PROPERTY SLOSH_PROGRAMS)
if(SLOSH_LEVEL)
    install(TARGETS ${programs} RUNTIME DESTINATION lib/sloshsph/${SLOSH_LEVEL})
    install(TARGETS chooseLevel RUNTIME DESTINATION lib/sloshsph)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/links)
    foreach(program ${programs})
        file(CREATE_LINK ../lib/sloshsph/chooseLevel ${PROJECT_BINARY_DIR}/links/${program} SYMBOLIC)
        install(FILES ${PROJECT_BINARY_DIR}/links/${program} DESTINATION bin)
    endforeach()
else()
    install(TARGETS ${programs} RUNTIME DESTINATION bin)
endif()
install(PROGRAMS ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/sloshMonitor DESTINATION bin)

install(DIRECTORY etc DESTINATION share/sloshsph USE_SOURCE_PERMISSIONS
        REGEX "/(install-dependencies|unpackParaview|buildPackage|tryPackage|completion.bash.in|write[A-Z][A-Za-z]*)$" EXCLUDE)
# Not what programs have written into the tutorials (as .gitignore has it).
install(DIRECTORY tutorials DESTINATION share/sloshsph USE_SOURCE_PERMISSIONS
        REGEX "/([0-9][^/]*|postProcessing|runs|VTK|polyMesh|log\\.[^/]*|[^/]*\\.foam|sweep\\.sbatch|\\.gitignore)$" EXCLUDE
        REGEX "/system/fv(Schemes|Solution)$" EXCLUDE
        REGEX "/validation/[^/]*\\.(png|txt|tsv|rows)$" EXCLUDE)
install(FILES tutorials/workPrecision/interFoam/system/fvSchemes tutorials/workPrecision/interFoam/system/fvSolution
        DESTINATION share/sloshsph/tutorials/workPrecision/interFoam/system)
install(FILES README.md CHANGELOG.md LICENSE CITATION.cff DESTINATION share/doc/sloshsph)
install(DIRECTORY docs/ DESTINATION share/doc/sloshsph/docs)
