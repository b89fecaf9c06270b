#pragma once
/// The few things of HDF5 that our files are made of.
#include <hdf5.h>

#include <functional>
#include <string>
#include <vector>

#include "bearing/case.hpp"

namespace shellback::app::hdf5 {

/// Of result files; one that a reader does not know is refused.
inline constexpr int kFormatVersion = 1;

/// Owns one HDF5 identifier; a negative one is the library's way to say no (FileError).
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t), const char* what);
  ~Handle() { close_(id_); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  operator hid_t() const { return id_; }  // NOLINT: an identifier is what the C interface takes

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Throws FileError if the library says no.
void check(herr_t outcome, const std::string& what);

/// The C library prints its error stack by default; our exception says what is needed.
class QuietErrors {
 public:
  QuietErrors();
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// What is written into it keeps its order.
[[nodiscard]] Handle group(hid_t parent, const char* name);

/// UTF-8 strings of any length; readers in Python and MATLAB take these as plain text.
[[nodiscard]] Handle text_type();

void attribute(hid_t owner, const std::string& name, hid_t type, const void* value);
void attribute(hid_t owner, const std::string& name, double value);
void attribute(hid_t owner, const std::string& name, int value);
void attribute(hid_t owner, const std::string& name, const std::string& value);

[[nodiscard]] std::string text_attribute(hid_t owner, const char* name);

/// What a reader must know of a dataset.
struct Meaning {
  std::string units;
  std::string long_name;
  std::string axes;   ///< coordinates of its dimensions, "phi z s"
  std::string state;  ///< empty: converged
};

using Shape = std::vector<hsize_t>;

/// `data` holds as many values of `type` as `shape` says.
void dataset(hid_t parent, const std::string& name, hid_t type, const void* data,
             const Shape& shape, const Meaning& meaning);
void texts(hid_t parent, const char* name, const std::vector<std::string>& lines,
           const Shape& shape, const Meaning& meaning);
void texts(hid_t parent, const char* name, const std::vector<std::string>& lines,
           const char* long_name);
void doubles(hid_t parent, const char* name, const std::vector<double>& values, const char* units,
             const char* long_name);

/// Groups case (its verbatim text) and provenance.
void write_origin(hid_t file, const bearing::Case& c);

/// The bytes of the file that `fill` writes into. It is made in memory: the library cannot close a
/// file on a full disk, and crashes later. Throws FileError if the library says no.
[[nodiscard]] std::string file_bytes(const std::function<void(hid_t)>& fill);

/// The attribute `format` of a file; empty if there is none or this is no sound HDF5 file.
[[nodiscard]] std::string format_of(const std::string& path);

}  // namespace shellback::app::hdf5
