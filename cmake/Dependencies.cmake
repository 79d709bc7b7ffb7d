# Every package that the project uses, once. Optional ones leave one line in the feature summary when absent.
include(FeatureSummary)
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

# Boost 1.81's message queue notices dead owners; 1.74 works with the timeout macro (docs/decisions).
find_package(Boost 1.74 REQUIRED COMPONENTS program_options)

find_package(assimp 5.2 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(fmt 9 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(hwy 1.0 REQUIRED)
find_package(ZLIB REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(TIFF REQUIRED)
find_path(CIMG_INCLUDE_DIR CImg.h PATHS ${CMAKE_SOURCE_DIR}/build/cimg REQUIRED) # or where scripts/setup.sh puts it

if(RT_WITH_OPENMP)
    find_package(OpenMP COMPONENTS CXX)
endif()
add_feature_info(OpenMP OpenMP_CXX_FOUND "all cores render and build")

find_package(OpenSSL QUIET)
add_feature_info(Nets OpenSSL_FOUND "nets that denoise, whose files are checked by OpenSSL")

find_package(draco QUIET)
add_feature_info(Draco draco_FOUND "glTF compressed by Draco")
find_package(meshoptimizer QUIET)
add_feature_info(Meshoptimizer meshoptimizer_FOUND "glTF compressed by meshoptimizer")

if(RT_WITH_OPENEXR)
    # By pkg-config: the CMake files of Debian's Imath refuse to load without a Python library packaged elsewhere.
    pkg_check_modules(OpenEXR IMPORTED_TARGET OpenEXR)
endif()
add_feature_info(OpenEXR OpenEXR_FOUND "EXR images")

if(RT_WITH_MAGICK)
    pkg_check_modules(MAGICK IMPORTED_TARGET Magick++)
endif()
add_feature_info(ImageMagick MAGICK_FOUND "rare image formats")

if(RT_WITH_GUI STREQUAL "AUTO")
    find_package(Qt6 6.4 QUIET COMPONENTS Widgets Network)
elseif(RT_WITH_GUI)
    find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets Network)
endif()
set(RT_HAS_GUI ${Qt6Widgets_FOUND})
add_feature_info(GUI RT_HAS_GUI "the window, by Qt 6")
if(RT_HAS_GUI)
    find_package(Qt6LinguistTools QUIET)
    add_feature_info(Translations Qt6LinguistTools_FOUND "the window in Czech")
    pkg_check_modules(QRENCODE QUIET IMPORTED_TARGET libqrencode)
    add_feature_info(QrCodes QRENCODE_FOUND "links of the bridge as QR codes")
endif()

if(RT_WITH_BRIDGE)
    pkg_check_modules(TURBOJPEG QUIET IMPORTED_TARGET libturbojpeg)
    pkg_check_modules(DEFLATE QUIET IMPORTED_TARGET libdeflate)
    if(NOT RT_WITH_BRIDGE STREQUAL "AUTO" AND NOT (TURBOJPEG_FOUND AND DEFLATE_FOUND))
        message(FATAL_ERROR "RTBridge needs libturbojpeg and libdeflate; install them or set RT_WITH_BRIDGE=OFF")
    endif()
endif()
if(TURBOJPEG_FOUND AND DEFLATE_FOUND)
    set(RT_HAS_BRIDGE ON)
    add_feature_info(BridgeTls OpenSSL_FOUND "the bridge by https, by OpenSSL")
endif()
add_feature_info(Bridge RT_HAS_BRIDGE "RTBridge, walking in a browser, by libturbojpeg and libdeflate")
