# Embree 3, the peer of tests and benchmarks. Optional; rtsuite itself never uses it.
find_package(embree 3 QUIET)
if(NOT embree_FOUND)
    message(STATUS "Embree 3 is absent (libembree-dev): the kernels are not compared with it in ${CMAKE_CURRENT_SOURCE_DIR}")
endif()
