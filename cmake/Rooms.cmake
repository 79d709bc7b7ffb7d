# A room is a folder of a library: one static target, included as "rtcore/<room>/<file>.h".
#   rt_room(rtcore accel SOURCES a.cpp b.cpp DEPENDS math scene [LINK ZLIB::ZLIB])
# DEPENDS names rooms of the same library whose headers its own headers include; CMake refuses cycles.
function(rt_room library room)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LINK" ${ARGN})
    set(target ${library}_${room})
    if(ARG_SOURCES)
        add_library(${target} STATIC ${ARG_SOURCES})
        rt_note_vector_code(${ARG_SOURCES})
        set(scope PUBLIC)
        target_link_libraries(${target} PRIVATE rt_compile_options ${ARG_LINK})
        rt_share_headers(${target} standard)
        rt_compile_together(${target})
    else()
        add_library(${target} INTERFACE)
        set(scope INTERFACE)
    endif()
    target_include_directories(${target} ${scope} ${CMAKE_SOURCE_DIR}/libs)
    list(TRANSFORM ARG_DEPENDS PREPEND ${library}_)
    target_link_libraries(${target} ${scope} ${ARG_DEPENDS})
endfunction()

# Sources that are compiled once for each instruction set are one large function for each: they are compiled alone, and
# watching where each of their values goes out of scope would make that five times as long.
function(rt_note_vector_code)
    foreach(source ${ARGN})
        file(STRINGS ${source} vectors REGEX "simd/foreach_target" LIMIT_COUNT 1)
        if(vectors)
            set_property(SOURCE ${source} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
            if(RT_SANITIZE MATCHES address)
                set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize-address-use-after-scope)
            endif()
        endif()
    endforeach()
endfunction()

# Eight sources at a time are compiled as one, so that headers are read and templates made once for them; not with a
# compiler cache, which does better. Their names, of unnamed namespaces too, have to differ; sources after the target
# are compiled alone.
function(rt_compile_together target)
    if(CMAKE_CXX_COMPILER_LAUNCHER)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    set_property(SOURCE ${ARGN} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU") # GCC takes them for one header
        target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
endfunction()

# GCC 12 sees writes past the end of strings in precompiled <string> that are not there (like GCC bug 105651).
function(rt_calm_warnings target)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow)
    endif()
endfunction()

# A target whose flags are others reads the headers as they are.
set(CMAKE_PCH_WARN_INVALID OFF)

# Headers of the standard library, compiled once for all targets; for tests ("test", "computing_test") with GoogleTest.
# Not with a compiler cache, which does not know when two such compilations are equal.
#   rt_share_headers(rtcore_scene standard)
function(rt_share_headers target set)
    if(CMAKE_CXX_COMPILER_LAUNCHER)
        return()
    endif()
    if(NOT TARGET rt_${set}_headers)
        file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/${set}_headers.cpp CONTENT "") # is not newer each time
        add_library(rt_${set}_headers OBJECT ${CMAKE_BINARY_DIR}/${set}_headers.cpp)
        target_link_libraries(rt_${set}_headers PRIVATE rt_compile_options)
        target_precompile_headers(rt_${set}_headers PRIVATE <algorithm> <array> <chrono> <cmath> <filesystem> <functional>
            <memory> <optional> <span> <string> <string_view> <utility> <vector>)
        if(set MATCHES test)
            target_link_libraries(rt_${set}_headers PRIVATE GTest::gtest)
            target_precompile_headers(rt_${set}_headers PRIVATE <gtest/gtest.h> <fstream> <random> <sstream> <thread>)
            rt_optimise_test(rt_${set}_headers ${set})
        endif()
    endif()
    rt_calm_warnings(${target})
    target_precompile_headers(${target} REUSE_FROM rt_${set}_headers)
endfunction()

# The own code of tests is compiled in half of the time so; what renders is in the libraries. Not the code of those that
# compute themselves, which would take ten times as long; with sanitizers it is that of the libraries which matters.
function(rt_optimise_test target set)
    if(RT_SANITIZE)
        set_target_properties(${target} PROPERTIES RT_TEST_CODE ON)
    endif()
    if(set STREQUAL computing_test AND NOT RT_SANITIZE)
        target_compile_options(${target} PRIVATE -O1)
    else()
        target_compile_options(${target} PRIVATE -O0)
    endif()
endfunction()

# A test program, its tests found by name. Thorough tests are those whose source says so: THOROUGH_ begins the name of a
# test, a suite or an instantiation (as gtest's DISABLED_ does); with the option THOROUGH all of a program are.
#   Without LABELS it is a unit test: the target `unit_tests` builds all of these, and most run under sanitizers too.
# `ctest -L unit` runs them, `ctest -L quick` all but the thorough ones, in less than a minute on two cores.
#   A quick test has the time that the preset gives each test: 120 s, four times what the longest one took on two cores
# with five builds beside it; ten times that with sanitizers. Others have an hour, since check-long.sh raises what they do.
#   COMPUTES: with vectors or many numbers of its own. QT: its flags are not those of other tests. ALONE: sources with
# names that others have (rt_compile_together). TOGETHER: those that are not thorough are run by one process, since they
# share what takes long to start; they count as skipped where they say this of it, and their label has `.short` behind it.
#   rt_test(accel SOURCES a_test.cpp LINK rtcore_accel [THOROUGH] [COMPUTES] [ALONE b.cpp] [QT]
#           [LABELS slow [TOGETHER "there is no piano"]])
add_custom_target(unit_tests)
# After a change eight are compiled again; where all is compiled, 24 at a time take two thirds of the processor time.
set(RT_TESTS_TOGETHER 8 CACHE STRING "So many sources of a test program are compiled as one")
function(rt_test name)
    cmake_parse_arguments(ARG "COMPUTES;QT;THOROUGH" "TOGETHER" "SOURCES;LINK;ALONE;LABELS" ${ARGN})
    add_executable(test_${name} ${ARG_SOURCES})
    target_link_libraries(test_${name} PRIVATE rt_compile_options ${ARG_LINK} GTest::gtest GTest::gtest_main)
    target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    set(set test)
    if(ARG_COMPUTES)
        set(set computing_test)
    endif()
    rt_optimise_test(test_${name} ${set})
    rt_note_vector_code(${ARG_SOURCES})
    rt_compile_together(test_${name} ${ARG_ALONE})
    set_target_properties(test_${name} PROPERTIES UNITY_BUILD_BATCH_SIZE ${RT_TESTS_TOGETHER})
    if(NOT ARG_QT)
        rt_share_headers(test_${name} ${set})
    endif()
    # One label for each kind, since labels are searched for a pattern.
    set(hour PROPERTIES TIMEOUT 3600)
    if(ARG_TOGETHER)
        rt_discover(${name} "*THOROUGH_*" ${hour} LABELS "${ARG_LABELS}")
        add_test(NAME ${name} COMMAND test_${name} --gtest_brief=1 --gtest_filter=-*THOROUGH_*)
        set_tests_properties(${name} ${hour} LABELS "${ARG_LABELS}.short" COST 1000 # long, so it begins first
                             SKIP_REGULAR_EXPRESSION "${ARG_TOGETHER}")
    elseif(ARG_LABELS)
        rt_discover(${name} "*" ${hour} LABELS "${ARG_LABELS}")
    elseif(ARG_THOROUGH)
        rt_discover(${name} "*" ${hour} LABELS unit)
    else()
        rt_discover(${name} "*THOROUGH_*" ${hour} LABELS unit)
        rt_discover(${name} "-*THOROUGH_*" PROPERTIES LABELS unit.quick)
    endif()
    if(NOT ARG_LABELS)
        add_dependencies(unit_tests test_${name})
    endif()
endfunction()

# Before ctest runs, not after each build: most builds are not followed by it.
function(rt_discover name filter)
    gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST TEST_FILTER "${filter}" ${ARGN})
endfunction()
