# One function for every folder under roomcast/: a static library, and the tests next to its sources.
#
#   roomcast_library(codec
#     SOURCES depth_encoder.cpp ...        # headers need not be listed
#     TESTS depth_encoder_test.cpp ...     # one test program per folder: roomcast_codec_test
#     LINK roomcast::core PkgConfig::VPX
#     PRECOMPILE <Eigen/Geometry>)         # costly headers of others that most tests need
#
# Tests named *_gl_test.cpp need a GL 4.5 context; they get a program and the CTest label "gl" of their own.
#
# Several sources of a library are compiled together (ROOMCAST_UNITY_BUILD), because most of a file's compile time is
# spent on headers. Names in anonymous namespaces must therefore differ from file to file. SEPARATE excludes a library.

add_library(roomcast_flags INTERFACE)
target_include_directories(roomcast_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(roomcast_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # For our own builds; warnings of other compilers must not break users' builds.
  $<$<BOOL:${ROOMCAST_WARNINGS_ARE_ERRORS}>:-Werror>
  # GCC 12 at -O3 wrongly reports overlaps and short regions (its bug 105651 and related ones).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-restrict;-Wno-stringop-overread>)
set(ROOMCAST_TEST_TIMEOUT_S 60)
if(ROOMCAST_SANITIZE)
  set(ROOMCAST_TEST_TIMEOUT_S 600)  # tests take ten times as long
  target_compile_options(roomcast_flags INTERFACE -fsanitize=${ROOMCAST_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(roomcast_flags INTERFACE -fsanitize=${ROOMCAST_SANITIZE})
endif()

set(ROOMCAST_SOURCES_AT_A_TIME 10)
set(ROOMCAST_TESTS_FOR_A_PRECOMPILED_HEADER 6)  # with fewer test files it costs more than it saves

# roomcast_test(TARGET LABEL SOURCE... [PRECOMPILE HEADER...]): HEADERs of other libraries are parsed once for all sources.
function(roomcast_test target label)
  cmake_parse_arguments(ARG "" "" "PRECOMPILE" ${ARGN})
  add_executable(${target} ${ARG_UNPARSED_ARGUMENTS})
  list(LENGTH ARG_UNPARSED_ARGUMENTS count)
  if(count GREATER_EQUAL ROOMCAST_TESTS_FOR_A_PRECOMPILED_HEADER)
    target_precompile_headers(${target} PRIVATE <algorithm> <atomic> <chrono> <cmath> <condition_variable> <cstdint> <filesystem>
      <fstream> <functional> <map> <memory> <mutex> <optional> <random> <set> <span> <sstream> <string> <thread> <unordered_map>
      <variant> <vector> <gmock/gmock.h> <gtest/gtest.h> ${ARG_PRECOMPILE})
    # GCC 12 sees overlaps that are not there (its bug 105651) where std::string comes from a precompiled header.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-restrict;-Wno-stringop-overflow>)
  endif()
  gtest_discover_tests(${target} TEST_PREFIX "${target}." DISCOVERY_TIMEOUT 30
    PROPERTIES LABELS ${label} TIMEOUT ${ROOMCAST_TEST_TIMEOUT_S})
endfunction()

function(roomcast_library name)
  cmake_parse_arguments(ARG "SEPARATE" "" "SOURCES;TESTS;LINK;PRECOMPILE" ${ARGN})
  if(ARG_SOURCES)
    add_library(roomcast_${name} STATIC ${ARG_SOURCES})
    if(ROOMCAST_UNITY_BUILD AND NOT ARG_SEPARATE)
      set_target_properties(roomcast_${name} PROPERTIES
        UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${ROOMCAST_SOURCES_AT_A_TIME})
    endif()
    set(scope PUBLIC)
  else()
    add_library(roomcast_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(roomcast::${name} ALIAS roomcast_${name})
  target_link_libraries(roomcast_${name} ${scope} roomcast_flags ${ARG_LINK})
  if(NOT ROOMCAST_TESTS)
    return()
  endif()
  set(gl_tests ${ARG_TESTS})
  list(FILTER gl_tests INCLUDE REGEX "_gl_test\\.cpp$")
  list(FILTER ARG_TESTS EXCLUDE REGEX "_gl_test\\.cpp$")
  if(ARG_TESTS)
    roomcast_test(roomcast_${name}_test unit ${ARG_TESTS} PRECOMPILE ${ARG_PRECOMPILE})
    target_link_libraries(roomcast_${name}_test PRIVATE roomcast_${name} GTest::gmock GTest::gtest_main)
  endif()
  if(gl_tests)
    roomcast_test(roomcast_${name}_gl_test gl ${gl_tests} PRECOMPILE ${ARG_PRECOMPILE})
    target_link_libraries(roomcast_${name}_gl_test PRIVATE roomcast_${name} GTest::gtest_main)
  endif()
endfunction()
