# SPDX-License-Identifier: Apache-2.0
# Who may include whom. CONTRIBUTING.md has the same as a drawing.

# Folder and the folders it may include from, itself aside. Of those in settings_FOLDER it may include what ends in
# _settings.h alone: plain structs.
set(may_math "")
set(may_parallel "")
set(may_optics math)
set(may_crystal math)
set(may_picture math)
set(may_sky picture optics math)
set(may_air optics math parallel)
set(may_trace sky picture crystal optics math parallel)
set(may_beam sky crystal optics math parallel)
set(may_recon sky picture math parallel)
set(may_photo sky picture math parallel)
set(may_view sky picture optics math)
set(may_scene sky picture crystal optics math)
set(settings_scene trace recon air)
set(may_render scene air trace beam recon photo view sky picture crystal optics math parallel)
set(may_cli render scene view photo trace recon sky picture crystal optics math parallel)
set(may_main cli render parallel)

# Third-party header (a regular expression of the start of its name) and the folders in which it may appear.
set(third_party
  "glm/|math,optics,crystal,picture,sky,trace,beam,recon,photo,view"
  "sleef\\.h|math"
  "xxhash\\.h|math"
  "embree[34]/|trace"
  "mpi\\.h|render"
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
