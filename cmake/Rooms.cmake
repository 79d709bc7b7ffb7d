# A room is a folder of a library: one static target, included as "rtcore/<room>/<file>.h".
#   rt_room(rtcore accel SOURCES a.cpp b.cpp DEPENDS math scene [LINK ZLIB::ZLIB])
# DEPENDS names rooms of the same library whose headers its own headers include; CMake refuses cycles.
function(rt_room library room)
    cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;LINK" ${ARGN})
    set(target ${library}_${room})
    if(ARG_SOURCES)
        add_library(${target} STATIC ${ARG_SOURCES})
        set(scope PUBLIC)
        target_link_libraries(${target} PRIVATE rt_compile_options ${ARG_LINK})
    else()
        add_library(${target} INTERFACE)
        set(scope INTERFACE)
    endif()
    target_include_directories(${target} ${scope} ${CMAKE_SOURCE_DIR}/libs)
    list(TRANSFORM ARG_DEPENDS PREPEND ${library}_)
    target_link_libraries(${target} ${scope} ${ARG_DEPENDS})
endfunction()

# A test program, its tests found by name. Without LABELS it is a unit test: the target `unit_tests` builds all of
# these, and they run under sanitizers too. `ctest -L unit` runs them, `ctest -L quick` all but those that the pattern
# THOROUGH names, in less than a minute on two cores.
#   rt_test(accel SOURCES a_test.cpp LINK rtcore_accel [THOROUGH "Slow.*:Other.OneTest"] [LABELS slow])
add_custom_target(unit_tests)
function(rt_test name)
    cmake_parse_arguments(ARG "" "THOROUGH" "SOURCES;LINK;LABELS" ${ARGN})
    add_executable(test_${name} ${ARG_SOURCES})
    target_link_libraries(test_${name} PRIVATE rt_compile_options ${ARG_LINK} GTest::gtest GTest::gtest_main)
    target_include_directories(test_${name} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
    # The tests' own code takes half as long to compile with sanitizers when it is not optimised.
    if(RT_SANITIZE)
        target_compile_options(test_${name} PRIVATE -O0)
    endif()
    set(others "*")
    if(NOT ARG_LABELS)
        add_dependencies(unit_tests test_${name})
        set(ARG_LABELS unit.quick) # one label for both, since labels are searched for a pattern
        if(ARG_THOROUGH)
            gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST TEST_FILTER "${ARG_THOROUGH}"
                PROPERTIES TIMEOUT 3600 LABELS unit)
            set(others "-${ARG_THOROUGH}")
        endif()
    endif()
    gtest_discover_tests(test_${name} DISCOVERY_MODE PRE_TEST TEST_FILTER "${others}"
        PROPERTIES TIMEOUT 3600 LABELS "${ARG_LABELS}")
endfunction()
