# One function for every folder under roomcast/: a static library, and the tests next to its sources.
#
#   roomcast_library(codec
#     SOURCES depth_encoder.cpp ...        # headers need not be listed
#     INNER_LOOPS steady_depth.cpp ...     # loops over pixels, points and matches, compiled with -O3
#     TESTS depth_encoder_test.cpp ...     # one test program per folder: roomcast_codec_test
#     TOGETHER RenderedBoards ...          # suites whose tests share a fixture that takes seconds: one CTest entry each
#     LINK roomcast::core PkgConfig::VPX)
#
# Tests named *_gl_test.cpp need a GL 4.5 context; they get a program and the CTest label "gl" of their own.
#
# Several sources of a library, and several of its tests, are compiled together (ROOMCAST_UNITY_BUILD), because most of
# a file's compile time is spent on headers. Names in anonymous namespaces must therefore differ from file to file.

add_library(roomcast_flags INTERFACE)
target_include_directories(roomcast_flags INTERFACE ${PROJECT_SOURCE_DIR})
target_compile_options(roomcast_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # For our own builds; warnings of other compilers must not break users' builds.
  $<$<BOOL:${ROOMCAST_WARNINGS_ARE_ERRORS}>:-Werror>
  # GCC 12 at -O3 wrongly reports overlaps and short regions (its bug 105651 and related ones).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<CONFIG:Release>>:-Wno-restrict;-Wno-stringop-overread>)
set(ROOMCAST_TEST_TIMEOUT_S 180)  # six times what the longest takes, for slow machines
if(ROOMCAST_SANITIZE)
  set(ROOMCAST_TEST_TIMEOUT_S 600)  # tests take ten times as long
  target_compile_options(roomcast_flags INTERFACE -fsanitize=${ROOMCAST_SANITIZE}
    -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(roomcast_flags INTERFACE -fsanitize=${ROOMCAST_SANITIZE})
endif()

set(ROOMCAST_SOURCES_AT_A_TIME 24)  # a compiler needs up to 1.2 GB for them
set(ROOMCAST_TESTS_AT_A_TIME 10)

function(roomcast_compile_in_units target sources_at_a_time)
  if(ROOMCAST_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${sources_at_a_time})
  endif()
endfunction()

# roomcast_test(TARGET LABEL SOURCE... [TOGETHER SUITE...]): a test program whose tests CTest finds; LABEL is unit or gl.
# CTest runs each test in a process of its own, but a suite of TOGETHER as a whole.
function(roomcast_test target label)
  cmake_parse_arguments(ARG "" "" "TOGETHER" ${ARGN})
  add_executable(${target} ${ARG_UNPARSED_ARGUMENTS})
  target_compile_options(${target} PRIVATE -O1)  # compiled in two thirds of the time; what it tests stays as it is
  set(alone *)
  if(ARG_TOGETHER)
    list(TRANSFORM ARG_TOGETHER APPEND .* OUTPUT_VARIABLE together)
    list(JOIN together : together)
    set(alone -${together})
  endif()
  gtest_discover_tests(${target} TEST_PREFIX "${target}." TEST_FILTER ${alone} DISCOVERY_TIMEOUT 30
    PROPERTIES LABELS ${label} TIMEOUT ${ROOMCAST_TEST_TIMEOUT_S})
  foreach(suite IN LISTS ARG_TOGETHER)
    add_test(NAME ${target}.${suite} COMMAND ${target} --gtest_filter=${suite}.*)
    set_tests_properties(${target}.${suite} PROPERTIES LABELS ${label} TIMEOUT ${ROOMCAST_TEST_TIMEOUT_S}
      FAIL_REGULAR_EXPRESSION "Running 0 tests")
  endforeach()
endfunction()

function(roomcast_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;INNER_LOOPS;TESTS;TOGETHER;LINK" ${ARGN})
  if(ARG_INNER_LOOPS)
    add_library(roomcast_${name}_inner_loops OBJECT ${ARG_INNER_LOOPS})
    target_link_libraries(roomcast_${name}_inner_loops PRIVATE roomcast_flags ${ARG_LINK})
    # They compare floats, but never read errno or floating-point exceptions.
    target_compile_options(roomcast_${name}_inner_loops PRIVATE -O3 -fno-math-errno -fno-trapping-math)
    roomcast_compile_in_units(roomcast_${name}_inner_loops ${ROOMCAST_SOURCES_AT_A_TIME})
    list(APPEND ARG_SOURCES $<TARGET_OBJECTS:roomcast_${name}_inner_loops>)
  endif()
  if(ARG_SOURCES)
    add_library(roomcast_${name} STATIC ${ARG_SOURCES})
    roomcast_compile_in_units(roomcast_${name} ${ROOMCAST_SOURCES_AT_A_TIME})
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
    roomcast_test(roomcast_${name}_test unit ${ARG_TESTS} TOGETHER ${ARG_TOGETHER})
    roomcast_compile_in_units(roomcast_${name}_test ${ROOMCAST_TESTS_AT_A_TIME})
    target_link_libraries(roomcast_${name}_test PRIVATE roomcast_${name} GTest::gmock GTest::gtest_main)
  endif()
  if(gl_tests)
    roomcast_test(roomcast_${name}_gl_test gl ${gl_tests})
    roomcast_compile_in_units(roomcast_${name}_gl_test ${ROOMCAST_TESTS_AT_A_TIME})
    target_link_libraries(roomcast_${name}_gl_test PRIVATE roomcast_${name} GTest::gtest_main)
  endif()
endfunction()

# roomcast_part_of_shared_library(NAME...): these libraries go into a shared one, whose objects must be position-independent
# and which does not show them.
function(roomcast_part_of_shared_library)
  foreach(part IN LISTS ARGN)
    get_target_property(type roomcast_${part} TYPE)
    if(NOT type STREQUAL "INTERFACE_LIBRARY")
      set_target_properties(roomcast_${part} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
    endif()
    if(TARGET roomcast_${part}_inner_loops)
      set_target_properties(roomcast_${part}_inner_loops PROPERTIES
        POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
    endif()
  endforeach()
endfunction()
