#pragma once
/// Eigen, with one alignment for all who hand its objects to one another.
///
/// Eigen aligns its memory for the vector registers it is compiled for, and frees it accordingly:
/// a matrix made by a library for 512-bit registers and freed by a program for 128-bit ones ends
/// the program. The alignment is therefore that of the widest registers everywhere, set by the
/// CMake targets and checked here.
#ifndef EIGEN_MAX_ALIGN_BYTES
#error "link the CMake target shellback::shellback: it sets Eigen's alignment, as in the library"
#endif
#include <Eigen/Dense>

namespace shellback {

inline constexpr int kEigenAlignment = 64;  ///< of 512-bit registers [bytes]
static_assert(EIGEN_MAX_ALIGN_BYTES == kEigenAlignment &&
                  EIGEN_MAX_STATIC_ALIGN_BYTES == kEigenAlignment &&
                  EIGEN_DEFAULT_ALIGN_BYTES == kEigenAlignment,
              "Eigen is aligned otherwise than in the library; link shellback::shellback");

}  // namespace shellback
