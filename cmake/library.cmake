# A library per folder, in the order of the arrows: linking is the arrow.
#   shellback_library(NAME sources... LINKS libraries... [PROSE])
# Its users get the include root, C++20, Eigen's alignment and the libraries; the flags stay here.
# PROSE: what reads, writes, draws and judges the answers of others, optimized less for two thirds of
# its time to compile.
function(shellback_library name)
  cmake_parse_arguments(ARG "PROSE" "" "LINKS" ${ARGN})
  add_library(shellback_${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
  add_library(shellback::${name} ALIAS shellback_${name})
  set_target_properties(shellback_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(shellback_${name} PUBLIC cxx_std_20)
  target_include_directories(shellback_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/shellback>)
  target_compile_definitions(shellback_${name} PUBLIC ${SHELLBACK_EIGEN_ALIGNMENT})
  target_link_libraries(shellback_${name} PUBLIC ${ARG_LINKS}
    PRIVATE $<BUILD_INTERFACE:shellback_flags>)
  set_target_properties(shellback_${name} PROPERTIES
    UNITY_BUILD ${SHELLBACK_UNITY} UNITY_BUILD_BATCH_SIZE 16)
  # GCC takes the optimization of a whole source from its precompiled header: one header a kind.
  set(kind core)
  if(ARG_PROSE)
    set(kind words)
    target_compile_options(shellback_${name} PRIVATE ${SHELLBACK_PROSE_OPTIONS})
  endif()
  if(name STREQUAL kind)
    target_precompile_headers(shellback_${name} PRIVATE ${SHELLBACK_PRECOMPILED})
  else()
    target_precompile_headers(shellback_${name} REUSE_FROM shellback_${kind})
  endif()
endfunction()

if(SHELLBACK_SANITIZE)
  set(SHELLBACK_PROSE_OPTIONS -O0)
elseif(CMAKE_BUILD_TYPE STREQUAL "Release")
  set(SHELLBACK_PROSE_OPTIONS -O1)
endif()

# Eigen's objects pass between the libraries and their users, who may be compiled for other
# registers: one alignment for all, that of the widest (core/eigen.hpp).
set(SHELLBACK_EIGEN_ALIGNMENT EIGEN_MAX_ALIGN_BYTES=64 EIGEN_MAX_STATIC_ALIGN_BYTES=64)

# Headers of others that most sources read: parsed once. A third of all building was their parsing.
set(SHELLBACK_PRECOMPILED <Eigen/Dense> <algorithm> <array> <cmath> <filesystem> <fmt/format.h>
  <functional> <limits> <map> <memory> <numbers> <optional> <span> <sstream> <string> <variant>
  <vector>)
