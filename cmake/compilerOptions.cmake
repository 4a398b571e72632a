# SPDX-License-Identifier: GPL-3.0-or-later
# Options every target is compiled with.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

add_library(slosh_options INTERFACE)
add_library(slosh::options ALIAS slosh_options)
target_include_directories(slosh_options INTERFACE ${PROJECT_SOURCE_DIR}/src)

# -ffp-contract=off: each compiler and each level of the instruction set would fuse other operations, and give other bits.
# What is to be fused says multiplyAdd (base/scalarMath.hpp). -fno-math-errno lets sqrt vectorise.
target_compile_options(slosh_options INTERFACE -Wall -Wextra -Werror -ffp-contract=off -fno-math-errno -fno-trapping-math)
# Faults of gcc 12 itself: it warns of the deliberately undefined operand in its own AVX-512 intrinsics (GCC bug 105593)
# and of overlaps inside std::string that cannot be (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(slosh_options INTERFACE -Wno-uninitialized -Wno-maybe-uninitialized -Wno-restrict)
endif()
if(SLOSH_LEVEL)
    target_compile_options(slosh_options INTERFACE -march=${SLOSH_LEVEL})
elseif(SLOSH_NATIVE)
    target_compile_options(slosh_options INTERFACE -march=native)
endif()
# The masked assignment of libstdc++ 12's simd, compiled by clang for AVX-512, takes the lanes that are not in the mask
# (Select.TakesEachLaneFromWhereItsConditionSays shows it). Vectors of 256 bits are right.
if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(slosh_options INTERFACE -mno-avx512f)
endif()
if(SLOSH_SANITIZE)
    target_compile_options(slosh_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(slosh_options INTERFACE -fsanitize=address,undefined)
endif()

set(CMAKE_CXX_FLAGS_RELEASE "-O3 -DNDEBUG")
if(SLOSH_SANITIZE)
    # Unoptimised, the tests would take five times as long. Their own sources are (tests/CMakeLists.txt).
    set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g")
endif()
# Eigen's and the library's own assertions on, at nearly the speed of a release.
set(CMAKE_CXX_FLAGS_RELWITHASSERTIONS "-O2 -g -D_GLIBCXX_ASSERTIONS")

# slosh_run_once(<targets>): compiled with -O1 in a release, in two thirds of the time.
function(slosh_run_once)
    foreach(target ${ARGN})
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endforeach()
endfunction()
