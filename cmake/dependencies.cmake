# SPDX-License-Identifier: Apache-2.0
# Every third-party library, found once. scripts/install-deps installs them all.

find_package(Threads REQUIRED)
find_package(PkgConfig REQUIRED)
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenEXR 3 CONFIG REQUIRED)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(CLI11 CONFIG REQUIRED)
find_package(nlohmann_json CONFIG REQUIRED)
find_path(KISSFFT_INCLUDE_DIR kissfft/kissfft.hh REQUIRED)  # its C++ class is a header alone
pkg_check_modules(SLEEF REQUIRED IMPORTED_TARGET sleef)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)
pkg_check_modules(TURBOJPEG REQUIRED IMPORTED_TARGET libturbojpeg)
pkg_check_modules(LCMS REQUIRED IMPORTED_TARGET lcms2)
pkg_check_modules(CAIRO REQUIRED IMPORTED_TARGET cairo)
pkg_check_modules(TOMLPLUSPLUS REQUIRED IMPORTED_TARGET tomlplusplus)

# Embree 4 where it is to be had, else 3.12 or later; src/trace/embree_api.h hides the difference.
find_package(embree 4 CONFIG QUIET)
if(NOT embree_FOUND)
  find_package(embree 3.12 CONFIG REQUIRED)
endif()
message(STATUS "Embree ${embree_VERSION}")

if(PARHELION_MPI)
  find_package(MPI REQUIRED COMPONENTS CXX)
endif()

if(PARHELION_TESTS)
  find_package(doctest CONFIG REQUIRED)
endif()
