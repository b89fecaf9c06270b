#pragma once
/// Reading HDF5 back, independent of the writer's helpers.
#include <hdf5.h>

#include <catch2/catch.hpp>
#include <string>
#include <vector>

namespace shellback::test {

/// An open file, through the C interface.
struct Reader {
  explicit Reader(const std::string& path)
      : file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)) {
    REQUIRE(file >= 0);
  }
  ~Reader() { H5Fclose(file); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  [[nodiscard]] bool has(const std::string& path) const {
    return H5Lexists(file, path.c_str(), H5P_DEFAULT) > 0;
  }
  [[nodiscard]] double number(const std::string& object, const std::string& name) const {
    double value = 0.0;
    const hid_t id = H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(id >= 0);
    H5Aread(id, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(id);
    return value;
  }
  [[nodiscard]] std::string text(const std::string& object, const std::string& name) const {
    const hid_t id = H5Aopen_by_name(file, object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT);
    REQUIRE(id >= 0);
    const hid_t type = H5Aget_type(id);
    char* value = nullptr;
    H5Aread(id, type, &value);
    std::string copy = value ? value : "";
    H5free_memory(value);
    H5Tclose(type);
    H5Aclose(id);
    return copy;
  }
  [[nodiscard]] std::vector<hsize_t> shape(const std::string& path) const {
    const hid_t id = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
    REQUIRE(id >= 0);
    const hid_t space = H5Dget_space(id);
    std::vector<hsize_t> shape(H5Sget_simple_extent_ndims(space));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    H5Sclose(space);
    H5Dclose(id);
    return shape;
  }
  [[nodiscard]] std::vector<double> values(const std::string& path) const {
    hsize_t size = 1;
    for (const auto n : shape(path)) size *= n;
    std::vector<double> values(size);
    const hid_t id = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
    H5Dread(id, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(id);
    return values;
  }

  hid_t file;
};

/// Names of datasets without units or long_name.
inline herr_t note_unlabelled(hid_t root, const char* name, const H5O_info_t* info, void* names) {
  if (info->type != H5O_TYPE_DATASET) return 0;
  for (const char* label : {"units", "long_name"}) {
    if (H5Aexists_by_name(root, name, label, H5P_DEFAULT) <= 0) {
      static_cast<std::vector<std::string>*>(names)->push_back(name);
    }
  }
  return 0;
}

}  // namespace shellback::test
