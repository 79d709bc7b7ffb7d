# The program that reads models for the others, beside them; docs/import.md.
add_executable(rtimport ${CMAKE_SOURCE_DIR}/apps/common/importer_main.cpp)
target_link_libraries(rtimport PRIVATE app_common rt_compile_options rtcore_io_import_assimp rtcore_io_bsp)
install(TARGETS rtimport DESTINATION libexec/rtsuite)
