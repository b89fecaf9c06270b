#pragma once
/// The columns of a table of flow factors: one list for its writer and its reader.
#include <array>
#include <vector>

#include "fluid/measured_factors.hpp"

namespace shellback::app {

struct FactorColumn {
  const char* name;
  std::vector<double> fluid::FactorTable::*values;
  bool required = true;
};
inline constexpr std::array kFactorColumns{
    FactorColumn{"h_over_sigma", &fluid::FactorTable::H},
    FactorColumn{"average_gap", &fluid::FactorTable::average_gap},
    FactorColumn{"phi_x", &fluid::FactorTable::phi_x},
    FactorColumn{"phi_z", &fluid::FactorTable::phi_z},
    FactorColumn{"phi_s", &fluid::FactorTable::phi_s},
    FactorColumn{"phi_f", &fluid::FactorTable::phi_f},
    FactorColumn{"phi_fs", &fluid::FactorTable::phi_fs},
    FactorColumn{"phi_fp", &fluid::FactorTable::phi_fp, false}};

/// Columns that are written for the reader's eye and not needed: standard errors, what the map is.
inline constexpr std::array kFactorNotes{"gamma",        "contact_area", "phi_x_error",
                                         "phi_z_error",  "phi_s_error",  "phi_f_error",
                                         "phi_fs_error", "phi_fp_error"};

}  // namespace shellback::app
