# SPDX-License-Identifier: GPL-3.0-or-later
# slosh_library(<folder> USES <targets>): the library of src/<folder>. A folder of headers only becomes an
# interface library; the name seen by others is slosh::<folder> either way.
function(slosh_library folder)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES")
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${folder}/*.cpp)
    if(sources)
        add_library(slosh_${folder} STATIC ${sources})
        target_link_libraries(slosh_${folder} PUBLIC slosh::options ${arg_USES})
    else()
        add_library(slosh_${folder} INTERFACE)
        target_link_libraries(slosh_${folder} INTERFACE slosh::options ${arg_USES})
    endif()
    add_library(slosh::${folder} ALIAS slosh_${folder})
endfunction()

# slosh_application(<name> <folder> USES <targets>): a program made of every source in <folder>.
function(slosh_application name folder)
    cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "USES")
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE slosh::options ${arg_USES})
    set_property(GLOBAL APPEND PROPERTY SLOSH_PROGRAMS ${name})
endfunction()

# slosh_unit_tests(<folder>): tests/unit/<folder>/*.cpp against the library of src/<folder>. Tests whose suite, or whose
# instantiation, has a name that begins with Long take a second: their label is unit-long.
function(slosh_unit_tests folder)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/unit/${folder}/*.cpp)
    if(NOT sources)
        return()
    endif()
    add_executable(unit_${folder} ${sources})
    target_link_libraries(unit_${folder} PRIVATE slosh::${folder} GTest::gtest_main)
    add_dependencies(unitTests unit_${folder})
    gtest_discover_tests(unit_${folder} TEST_PREFIX "unit/${folder}/" TEST_FILTER "-Long*"
                         TEST_LIST unit_${folder}_short PROPERTIES LABELS "unit")
    gtest_discover_tests(unit_${folder} TEST_PREFIX "unit/${folder}/" TEST_FILTER "Long*"
                         TEST_LIST unit_${folder}_long PROPERTIES LABELS "unit-long")
endfunction()

# slosh_program_tests(<name> <folder>): <folder>/*.cpp, tests that start the programs as users do. They see what the
# programs write through the headers of the case layer at most.
function(slosh_program_tests name folder)
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
    add_executable(${name} ${sources})
    target_link_libraries(${name} PRIVATE slosh::options slosh::particles GTest::gtest_main)
    target_compile_definitions(${name} PRIVATE SLOSH_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}"
                               SLOSH_SOURCE="${PROJECT_SOURCE_DIR}")
    add_dependencies(${name} programs)
    gtest_discover_tests(${name} TEST_PREFIX "${folder}/" PROPERTIES LABELS "${folder}")
endfunction()

# slosh_choices(<folder> <class> <names>): what a dictionary can choose as <class> of src/<folder>, made into the table
# <class>::choices(). Each name is a constant of type <class>::Choice that a source of the folder defines in namespace choices.
function(slosh_choices folder class)
    list(TRANSFORM ARGN PREPEND "choices::" OUTPUT_VARIABLE listed)
    list(JOIN listed ", " listed)
    list(JOIN ARGN ", " declared)
    set(source ${PROJECT_BINARY_DIR}/generated/${folder}/${class}Choices.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/src/dictionary/choices.cpp.in ${source} @ONLY)
    target_sources(slosh_${folder} PRIVATE ${source})
endfunction()

# slosh_types(<folder> <kind> <names>): the types of src/<folder> that a dictionary can choose as <kind>, a header each;
# <folder>/<kind>Choice.hpp is made of <kind>Choice.hpp.in, which has a variant of them.
function(slosh_types folder kind)
    list(TRANSFORM ARGN REPLACE "(.+)" "#include \"${folder}/\\1.hpp\"" OUTPUT_VARIABLE includes)
    list(JOIN includes "\n" includes)
    list(JOIN ARGN ", " types)
    set(generated ${PROJECT_BINARY_DIR}/generated)
    configure_file(${PROJECT_SOURCE_DIR}/src/${folder}/${kind}Choice.hpp.in ${generated}/${folder}/${kind}Choice.hpp @ONLY)
    target_include_directories(slosh_${folder} PUBLIC ${generated})
endfunction()

# slosh_kernels(<names>): the kernels of src/kernels. kernels/KernelChoice.hpp lists them; the sums over pairs are compiled for each in
# two and three dimensions and for each scalar type, a source a kernel, and physics/interactions.hpp says so.
function(slosh_kernels)
    slosh_types(kernels Kernel ${ARGN})
    set(generated ${PROJECT_BINARY_DIR}/generated)
    set(sources)
    set(all "")
    foreach(kernel ${ARGN})
        set(instantiations "")
        foreach(scalar double SimdOfRows<double> SimdOfRows<float>)
            foreach(dim 2 3)
                string(APPEND instantiations "template class PairInteractions<${dim}, ${kernel}, ${scalar}>;\n")
            endforeach()
        endforeach()
        string(REPLACE "template class" "extern template class" declarations "${instantiations}")
        string(APPEND all "${declarations}")
        configure_file(${PROJECT_SOURCE_DIR}/src/physics/interactions.cpp.in ${generated}/physics/interactions_${kernel}.cpp @ONLY)
        list(APPEND sources ${generated}/physics/interactions_${kernel}.cpp)
    endforeach()
    configure_file(${PROJECT_SOURCE_DIR}/src/physics/interactions.hpp.in ${generated}/physics/interactions.hpp @ONLY)
    set(SLOSH_INTERACTIONS ${sources} PARENT_SCOPE)
endfunction()
