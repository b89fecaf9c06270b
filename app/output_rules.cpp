#include "app/output_rules.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "app/file_identity.hpp"
#include "app/pending_file.hpp"
#include "core/contract.hpp"

namespace shellback::app {
namespace {

namespace fs = std::filesystem;

/// What an extension promises. One that is not listed promises nothing.
struct Extension {
  const char* text;
  const char* promise;
  std::vector<Format> fits;
};
const std::vector<Extension> kExtensions{
    {".h5", "HDF5", {Format::hdf5}},
    {".hdf5", "HDF5", {Format::hdf5}},
    {".json", "JSON", {Format::json}},
    {".csv", "a table (CSV)", {Format::csv, Format::coefficients}},
    {".html", "a page (HTML)", {Format::html}},
    {".htm", "a page (HTML)", {Format::html}},
    {".svg", "a drawing (SVG)", {Format::svg}},
    {".png", "pixels (PNG)", {Format::png}},
    {".md", "Markdown", {Format::markdown}},
    {".vtu", "a film for ParaView (VTK)", {Format::vtk}},
    {".pvd", "films for ParaView (VTK)", {Format::vtk}},
    {".toml", "a case (TOML)", {Format::toml}},
    {".txt", "text", {Format::json, Format::csv, Format::coefficients, Format::markdown}},
    {".pdf", "PDF", {}},
    {".jpg", "JPEG", {}},
    {".jpeg", "JPEG", {}},
    {".xlsx", "a spreadsheet", {}},
    {".xls", "a spreadsheet", {}},
    {".ods", "a spreadsheet", {}},
    {".xml", "XML", {}},
    {".yaml", "YAML", {}},
    {".zip", "an archive", {}},
    {".gz", "an archive", {}},
};

bool fits(const Extension& extension, Format format) {
  return std::find(extension.fits.begin(), extension.fits.end(), format) != extension.fits.end();
}

/// The extension that a format is best known by; the list begins with these.
const Extension& usual_extension(Format format) {
  return *std::find_if(kExtensions.begin(), kExtensions.end(),
                       [&](const Extension& e) { return fits(e, format); });
}

void expect_fitting_extension(const Output& output) {
  std::string text = fs::path(output.path).extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  for (const Extension& extension : kExtensions) {
    if (text != extension.text || fits(extension, output.format)) continue;
    const Extension& usual = usual_extension(output.format);
    throw InputError(output.option,
                     fmt::format("{} promises {}, but what is written is {}; name it {}",
                                 output.path, extension.promise, usual.promise,
                                 fs::path(output.path).replace_extension(usual.text).string()));
  }
}

void expect_no_input(const Output& output, const std::vector<std::string>& inputs) {
  for (const std::string& input : inputs) {
    if (!same_file(output.path, input)) continue;
    throw InputError(
        output.option,
        fmt::format("{} is read by this run{}, and an output never replaces an input; "
                    "give it another name",
                    output.path, input == output.path ? "" : fmt::format(" as {}", input)));
  }
}

void expect_other(const Output& first, const Output& second) {
  const bool streams = is_stream(first.path) || is_stream(second.path);
  if (first.path == "-" && second.path == "-") {
    throw InputError(second.option,
                     first.option + " has standard output already; give one of them a file");
  }
  if (first.path == "-" || second.path == "-" || streams) return;
  if (!same_file(first.path, second.path)) return;
  throw InputError(second.option, fmt::format("{} is written by {} already; give each its own file",
                                              second.path, first.option));
}

/// Creates the file's predecessor and lets it go: nothing else proves that a file can be written.
void expect_place(const Output& output) {
  const fs::path folder = target_of(output.path).parent_path();
  if (!fs::is_directory(folder)) {
    throw FileError(fmt::format("{}: there is no folder {}; create it or choose another place",
                                output.path, folder.string()));
  }
  if (fs::is_directory(output.path)) {
    throw FileError(fmt::format("{}: this is a folder; give a file in it", output.path));
  }
  if (fs::exists(output.path) && ::access(output.path.c_str(), W_OK) != 0) {
    throw FileError(
        fmt::format("{}: the file is write-protected; choose another name", output.path));
  }
  const PendingFile probe(output.path);
}

}  // namespace

void expect_replaceable(const Output& output, bool force) {
  std::error_code error;
  if (force || is_stream(output.path) || !fs::is_regular_file(output.path, error)) return;
  if (fs::file_size(output.path, error) == 0 || is_result(output.path)) return;
  throw InputError(output.option,
                   fmt::format("{} exists and is no result of shellback, so it is left as it is; "
                               "give another name, or --force to replace it",
                               output.path));
}

void expect_sound(const std::vector<Output>& outputs, const std::vector<std::string>& inputs,
                  bool force) {
  for (const Output& output : outputs) {
    if (output.path == "-") continue;
    if (!is_stream(output.path)) expect_no_input(output, inputs);
    expect_fitting_extension(output);
  }
  for (std::size_t b = 1; b < outputs.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) expect_other(outputs[a], outputs[b]);
  }
  for (const Output& output : outputs) {
    if (output.path == "-" || is_stream(output.path)) continue;
    expect_place(output);
    expect_replaceable(output, force);
  }
}

}  // namespace shellback::app
