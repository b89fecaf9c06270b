#include "app/reading/csv_table.hpp"
#include "app/reading/sections.hpp"
#include "app/reading/surface_columns.hpp"

namespace shellback::app {

fluid::FactorTable read_flow_factors(const std::string& path) {
  std::vector<CsvKind> possible{{"sigma", kLength}};
  for (const FactorColumn& column : kFactorColumns) possible.push_back({column.name, kNumber});
  for (const char* also : kFactorNotes) possible.push_back({also, kNumber});
  const CsvTable csv(path, possible, "h_over_sigma [1], average_gap [1], phi_x [1], ...");
  fluid::FactorTable table;
  table.name = path;
  for (const FactorColumn& column : kFactorColumns) {
    if (column.required || csv.has(column.name)) table.*column.values = csv.column(column.name);
  }
  const std::vector<double>& sigma = csv.column("sigma");
  for (std::size_t row = 0; row < csv.rows(); ++row) {
    if (!(sigma[row] > 0.0) || sigma[row] != sigma[0]) {
      csv.fail(row, "sigma", "sigma is the roughness of the map: positive, the same in every row");
    }
  }
  if (csv.rows() > 0) table.sigma = sigma[0];
  const fluid::FactorFault fault = fluid::fault_of(table);
  if (fault.problem.empty()) return table;
  if (csv.rows() == 0) csv.fail_header(fault.problem);
  csv.fail(fault.row, fault.column, fault.problem);
}

}  // namespace shellback::app
