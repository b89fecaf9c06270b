/// report and export: what a result file holds, as a page and for ParaView.
#include <filesystem>
#include <iostream>

#include "app/pending_file.hpp"
#include "app/program/commands.hpp"
#include "app/program/outputs.hpp"
#include "app/read_result.hpp"
#include "app/write_report.hpp"
#include "app/write_vtu.hpp"
#include "core/contract.hpp"

namespace shellback::program {

using namespace app;

int report(const Request& request) {
  Outputs outputs(request, {request.case_file});
  const StoredResult result = read_result(request.case_file);
  outputs.give("-o", [&] { return report_html(result); });
  return outputs.code(kDone);
}

namespace {

/// Films that an earlier export left there would be taken for instants of this one.
void remove_older_films(const std::filesystem::path& folder) {
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    const bool film =
        name == "film.pvd" || (name.starts_with("film") && entry.path().extension() == ".vtu");
    std::error_code ignored;  // what cannot be removed cannot be written either, which is told
    if (film && is_result(entry.path().string())) std::filesystem::remove(entry.path(), ignored);
  }
}

}  // namespace

int export_film(const Request& request) {
  namespace fs = std::filesystem;
  const StoredResult result = read_result(request.case_file);
  const std::vector<VtuFile> files = film_vtu(result);
  const fs::path folder(request.vtu);
  if (fs::exists(folder) && !fs::is_directory(folder)) {
    throw InputError("--vtu", request.vtu + " is a file; give a folder");
  }
  std::error_code refused;
  fs::create_directory(folder, refused);
  if (refused) {
    throw FileError(request.vtu + ": the folder cannot be made (" + refused.message() + ")");
  }
  std::vector<Output> wanted;
  for (const VtuFile& file : files) {
    wanted.push_back({"--vtu", (folder / file.name).string(), Format::vtk});
  }
  expect_sound(wanted, {request.case_file}, request.force);
  remove_older_films(folder);
  for (std::size_t k = 0; k < files.size(); ++k) {
    write_file(wanted[k].path, marked(Format::vtk, files[k].content));
  }
  std::cout << files.size() << (files.size() == 1 ? " file" : " files") << " in " << request.vtu
            << ": open film." << (files.size() == 1 ? "vtu" : "pvd") << " in ParaView\n";
  if (!result.converged) {
    std::cerr << "warning: not converged (" << result.status
              << "): these fields are those of the last iterate, not a result\n";
  }
  return kDone;
}

}  // namespace shellback::program
