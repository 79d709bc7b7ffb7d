# cpack -G DEB, cpack -G TGZ in the build folder; scripts/check-package.sh tries the result.
set(CPACK_PACKAGE_NAME rtsuite)
set(CPACK_PACKAGE_VENDOR "the rtsuite authors")
set(CPACK_PACKAGE_CONTACT "the rtsuite authors <maintainers@rtsuite.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "interactive ray tracing on processors")
set(CPACK_PACKAGE_DESCRIPTION
"Renders 3D models of many formats by ray tracing, at interactive rates and
without a graphics card. RTServer shows a scene in which one walks about, CUI
commands it from a shell, RTBridge shows it in a browser, Renderer makes stills
and films in high quality, and BSPBuilder prepares models so that they load
quickly.")
set(CPACK_RESOURCE_FILE_LICENSE ${CMAKE_SOURCE_DIR}/LICENSE)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/open_folders.cmake)

# Without the benchmark, which may be linked with Embree.
set(CPACK_INSTALL_CMAKE_PROJECTS "${CMAKE_BINARY_DIR};rtsuite;Unspecified;/")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "ffmpeg")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "bash-completion, assimp-utils, npm")
if(TARGET GUI)
    string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", qt6-wayland, qt6-translations-l10n")
endif()

include(CPack)
