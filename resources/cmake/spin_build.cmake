# SPDX-FileCopyrightText: 2026 Spindrift contributors
# SPDX-License-Identifier: Apache-2.0
# Language level, warnings, sanitizers, ccache, and the two functions every folder uses.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
# Debug checks (SPIN_DCHECK) follow NDEBUG, which Release defines.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")

find_program(SPIN_CCACHE ccache)
if(SPIN_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${SPIN_CCACHE}")
  set(CMAKE_CUDA_COMPILER_LAUNCHER "${SPIN_CCACHE}")
endif()

add_library(spin_options INTERFACE)
target_include_directories(spin_options INTERFACE "${PROJECT_SOURCE_DIR}")
# Contraction off: a*b+c rounds alike in every instruction set unless a kernel asks for fma by name.
# No errno and no traps from math: the loops vectorise; NaN and infinity keep their meaning.
target_compile_options(spin_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off -fno-math-errno -fno-trapping-math -fvisibility=hidden -fvisibility-inlines-hidden>)
target_compile_options(spin_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wunused -Wnull-dereference -Wdouble-promotion -Wimplicit-fallthrough>)
if(SPIN_WARNINGS_AS_ERRORS)
  target_compile_options(spin_options INTERFACE $<$<COMPILE_LANGUAGE:CXX>:-Werror>)
endif()
target_compile_definitions(spin_options INTERFACE SPIN_VERSION="${PROJECT_VERSION}")
if(SPIN_SANITIZE)
  target_compile_options(spin_options INTERFACE -fsanitize=${SPIN_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -Wno-maybe-uninitialized -Wno-null-dereference)
  target_link_options(spin_options INTERFACE -fsanitize=${SPIN_SANITIZE})
endif()

# What the tests run with under a sanitizer, and how much longer they may take.
set(SPIN_TEST_PATIENCE 1)
set(SPIN_TEST_ENVIRONMENT)
if(SPIN_SANITIZE)
  set(SPIN_TEST_PATIENCE 5)
  set(tools "${PROJECT_SOURCE_DIR}/resources/tools")
  list(APPEND SPIN_TEST_ENVIRONMENT
    "ASAN_OPTIONS=check_initialization_order=1" "UBSAN_OPTIONS=print_stacktrace=1"
    "LSAN_OPTIONS=suppressions=${tools}/lsan.supp:print_suppressions=0" "TSAN_OPTIONS=suppressions=${tools}/tsan.supp:second_deadlock_stack=1")
endif()

find_package(Threads REQUIRED)

# spin_add_library(NAME DIRS dir... LINK lib...): a static library of all .cpp files in the folders (not below them).
function(spin_add_library name)
  cmake_parse_arguments(ARG "" "" "DIRS;LINK;EXCLUDE" ${ARGN})
  set(sources)
  foreach(dir ${ARG_DIRS})
    file(GLOB found CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${dir}/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/${dir}/*.h")
    list(APPEND sources ${found})
  endforeach()
  foreach(pattern ${ARG_EXCLUDE})
    list(FILTER sources EXCLUDE REGEX "${pattern}")
  endforeach()
  if(NOT sources)
    return()
  endif()
  add_library(${name} STATIC ${sources})
  set_target_properties(${name} PROPERTIES LINKER_LANGUAGE CXX)
  target_link_libraries(${name} PUBLIC spin_options ${ARG_LINK})
endfunction()

# spin_describe_test(NAME LABEL label TIMEOUT s [ENV VAR=value...]): what every test is told, sanitizers considered.
function(spin_describe_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "ENV" ${ARGN})
  math(EXPR timeout "${ARG_TIMEOUT} * ${SPIN_TEST_PATIENCE}")
  set(environment ${ARG_ENV} ${SPIN_TEST_ENVIRONMENT})
  set_tests_properties(${name} PROPERTIES LABELS "${ARG_LABEL}" TIMEOUT ${timeout} ENVIRONMENT "${environment}")
  if(ARG_LABEL MATCHES "gpu|interop")
    # A program that found no card, or no foreign program, has shown nothing: ctest says so.
    set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "SKIPPED")
  endif()
endfunction()

# spin_add_test(NAME LABEL label SOURCES file... LINK lib... [ENV VAR=value...] [TIMEOUT s]): one GoogleTest program.
function(spin_add_test name)
  cmake_parse_arguments(ARG "" "LABEL;TIMEOUT" "SOURCES;LINK;ENV" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} GTest::gtest GTest::gtest_main)
  add_test(NAME ${name} COMMAND ${name})
  spin_describe_test(${name} LABEL "${ARG_LABEL}" TIMEOUT ${ARG_TIMEOUT} ENV ${ARG_ENV})
endfunction()
