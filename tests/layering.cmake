# SPDX-License-Identifier: Apache-2.0
# Fails when a folder of src/ includes against the arrows of the house, or a third-party header outside the folders it
# belongs to. Run as: cmake -DSOURCE_DIR=.../src -P layering.cmake

cmake_minimum_required(VERSION 3.24)

# Folder and the folders it may include from, itself aside. Of those in settings_FOLDER it may include what ends in
# _settings.h alone: plain structs.
set(may_math "")
set(may_parallel "")
set(may_optics math)
set(may_crystal math)
set(may_picture math)
set(may_sky picture optics math)
set(may_trace sky picture crystal optics math parallel)
set(may_recon sky picture math parallel)
set(may_photo sky picture math parallel)
set(may_view sky picture optics math)
set(may_scene sky picture crystal optics math)
set(settings_scene trace recon)
set(may_render scene trace recon photo view sky picture crystal optics math parallel)
set(may_cli render scene view photo trace recon sky picture crystal optics math parallel)
set(may_main cli scene)

# Third-party header (a regular expression of the start of its name) and the folders in which it may appear.
set(third_party
  "glm/|math,optics,crystal,picture,sky,trace,recon,photo,view"
  "sleef\\.h|math"
  "embree[34]/|trace"
  "tbb/|parallel,trace"
  "kissfft/|recon"
  "Imf|picture,sky"
  "Iex|picture,sky"
  "Imath|picture,sky"
  "OpenEXR/|picture,sky"
  "png\\.h|picture"
  "jpeglib\\.h|picture"
  "turbojpeg\\.h|picture"
  "lcms2\\.h|picture"
  "cairo|view"
  "toml\\+\\+/|scene"
  "nlohmann/|scene,cli"
  "CLI/|cli")

set(problems "")
file(GLOB_RECURSE sources RELATIVE ${SOURCE_DIR} ${SOURCE_DIR}/*.h ${SOURCE_DIR}/*.cpp)
list(LENGTH sources count)
if(count LESS 20)
  message(FATAL_ERROR "found only ${count} source files in ${SOURCE_DIR}")
endif()

foreach(source IN LISTS sources)
  if(source STREQUAL "main.cpp")
    set(folder main)
  else()
    string(REGEX REPLACE "/.*" "" folder ${source})
  endif()
  if(NOT DEFINED may_${folder})
    string(APPEND problems "${source}: folder ${folder} is not part of the house\n")
    continue()
  endif()

  file(STRINGS ${SOURCE_DIR}/${source} includes REGEX "^ *#include")
  foreach(include IN LISTS includes)
    if(include MATCHES "#include \"([^/\"]+)/")
      set(target ${CMAKE_MATCH_1})
      set(allowed ${folder} ${may_${folder}})
      if(include MATCHES "_settings\\.h\"")
        list(APPEND allowed ${settings_${folder}})
      endif()
      if(NOT target IN_LIST allowed)
        string(APPEND problems "${source}: ${folder} may not include from ${target}\n")
      endif()
      # Methods of reconstruction do not know each other; one file knows all.
      if(include MATCHES "\"recon/(adaptive|published)/" AND source MATCHES "^recon/" AND
         NOT source STREQUAL "recon/reconstruct.cpp")
        string(REGEX MATCH "recon/(adaptive|published)/" room ${include})
        if(NOT source MATCHES "^${room}")
          string(APPEND problems "${source}: only recon/reconstruct.cpp and ${room} may include from ${room}\n")
        endif()
      endif()
    elseif(include MATCHES "#include <([^>]+)>")
      set(header ${CMAKE_MATCH_1})
      foreach(rule IN LISTS third_party)
        string(REGEX REPLACE "\\|.*" "" pattern ${rule})
        string(REGEX REPLACE ".*\\|" "" folders ${rule})
        string(REPLACE "," ";" folders ${folders})
        if(header MATCHES "^${pattern}" AND NOT folder IN_LIST folders)
          string(APPEND problems "${source}: <${header}> belongs in ${folders}\n")
        endif()
      endforeach()
    endif()
  endforeach()
endforeach()

if(problems)
  message(FATAL_ERROR "\n${problems}")
endif()
message(STATUS "${count} files keep to the house")
