/// A result file read back, its page and its film for ParaView.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <sstream>

#include "app/hdf5_parts.hpp"
#include "app/pending_file.hpp"
#include "app/read_result.hpp"
#include "app/result_mark.hpp"
#include "app/words/note_words.hpp"
#include "app/write_cycle_hdf5.hpp"
#include "app/write_hdf5.hpp"
#include "app/write_report.hpp"
#include "app/write_vtu.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "markup.hpp"
#include "synthetic.hpp"
#include "synthetic_cycle.hpp"
#include "tests/contains.hpp"

using namespace shellback;
using test::contains;

namespace {

app::StoredResult read_back(const std::string& bytes) {
  const test::ScratchFile scratch("output.h5");
  app::write_file(scratch.path(), bytes);
  return app::read_result(scratch.path());
}

app::StoredResult steady() {
  return read_back(app::result_hdf5(test::synthetic_case(), test::synthetic_result()));
}

app::StoredResult over_cycle() {
  return read_back(app::cycle_hdf5(test::cycle_case(), test::synthetic_cycle()));
}

void check_same(double a, double b) {
  if (std::isnan(a)) {
    CHECK(std::isnan(b));
  } else {
    CHECK(a == b);
  }
}

/// The numbers of a DataArray in VTK's XML.
std::vector<double> array_of(const std::string& xml, const std::string& name) {
  const std::size_t at = xml.find("Name=\"" + name + "\"");
  REQUIRE(at != std::string::npos);
  const std::size_t begin = xml.find('>', at) + 1;
  std::istringstream in(xml.substr(begin, xml.find('<', begin) - begin));
  std::vector<double> values;
  for (std::string word; in >> word;) values.push_back(std::stod(word));
  return values;
}

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Corners, half the cross product of the diagonals (its length is the area) and the middle.
struct Quad {
  Vector normal{}, middle{};
};
std::vector<Quad> quads_of(const std::string& xml) {
  const auto corners = array_of(xml, "corners [m]"), links = array_of(xml, "connectivity");
  std::vector<Quad> quads;
  for (std::size_t k = 0; k < links.size(); k += 4) {
    std::array<Vector, 4> at{};
    Quad quad;
    for (std::size_t c = 0; c < 4; ++c) {
      for (std::size_t x = 0; x < 3; ++x) {
        at[c][x] = corners[3 * static_cast<std::size_t>(links[k + c]) + x];
        quad.middle[x] += 0.25 * at[c][x];
      }
    }
    Vector one{}, other{};
    for (std::size_t x = 0; x < 3; ++x)
      one[x] = at[2][x] - at[0][x], other[x] = at[3][x] - at[1][x];
    quad.normal = cross(one, other);
    for (double& x : quad.normal) x *= 0.5;
    quads.push_back(quad);
  }
  return quads;
}

}  // namespace

TEST_CASE("AResultFileIsReadBackAsItWasWritten") {
  const bearing::Result result = test::synthetic_result();
  const app::StoredResult read = steady();
  CHECK(read.title == result.title);
  CHECK(read.tier == "tehd");
  CHECK(read.converged);
  REQUIRE(read.quantities.size() == result.quantities.size());
  for (std::size_t k = 0; k < result.quantities.size(); ++k) {  // in their order
    const bearing::Quantity &a = result.quantities[k], &b = read.quantities[k].quantity;
    CHECK(b.name == a.name);
    CHECK(b.unit == a.unit);
    check_same(a.value, b.value);
    check_same(a.error_grid, b.error_grid);
    check_same(a.error_model, b.error_model);
    check_same(a.limit, b.limit);
  }
  CHECK(read.grid.cells() == result.fields.grid.cells());
  CHECK(read.field("p")->values == result.fields.p);
  CHECK(read.field("T")->values == result.fields.T);
  CHECK(read.field("nothing") == nullptr);
  CHECK(read.warnings == app::words_of(result.warnings));
  CHECK(read.assumptions == app::words_of(result.assumptions));
  CHECK(read.effects.size() == result.effects.size());
  CHECK(read.verbatim == test::synthetic_case().verbatim);
  const bearing::CycleResult cycle = test::synthetic_cycle();
  const app::StoredResult stored = over_cycle();
  REQUIRE(stored.quantities.size() == cycle.quantities.size());
  for (std::size_t k = 0; k < cycle.quantities.size(); ++k) {
    CHECK(stored.quantities[k].quantity.name == cycle.quantities[k].quantity.name);
    CHECK(std::isfinite(stored.quantities[k].at) == std::isfinite(cycle.quantities[k].at));
  }
}

TEST_CASE("FilesWhoseListsAreNotAsLongAsTheyMustBeAreRefused") {
  const auto spoilt = [](const std::function<void(hid_t)>& change) {
    const test::ScratchFile scratch("output.h5");
    app::write_file(scratch.path(),
                    app::result_hdf5(test::synthetic_case(), test::synthetic_result()));
    {
      using app::hdf5::Handle;
      const Handle file(H5Fopen(scratch.path().c_str(), H5F_ACC_RDWR, H5P_DEFAULT), H5Fclose,
                        "file");
      change(file);
    }
    return app::read_result(scratch.path());
  };
  const auto shorter = [](hid_t file, const char* group, const char* name, std::size_t length) {
    const app::hdf5::Handle parent(H5Gopen2(file, group, H5P_DEFAULT), H5Gclose, group);
    H5Ldelete(parent, name, H5P_DEFAULT);
    const std::vector<double> values(length, 1.0);
    app::hdf5::dataset(parent, name, H5T_NATIVE_DOUBLE, values.data(), {length},
                       {"Pa", "shortened", "phi z", ""});
  };
  CHECK_NOTHROW(spoilt([](hid_t) {}));
  CHECK_THROWS_AS(spoilt([&](hid_t f) { shorter(f, "fields", "p", 3); }), FileError);
  CHECK_THROWS_AS(spoilt([&](hid_t f) { shorter(f, "grid", "z_face", 2); }), FileError);
  CHECK_THROWS_AS(spoilt([&](hid_t f) { shorter(f, "effects", "indicator", 1); }), FileError);
  CHECK_THROWS_AS(spoilt([&](hid_t f) { H5Adelete(f, "format_version"); }), FileError);
  try {
    static_cast<void>(spoilt([](hid_t f) {
      H5Adelete(f, "format_version");
      app::hdf5::attribute(f, "format_version", 99);
    }));
    FAIL("a format of the future is read");
  } catch (const InputError& error) {
    CHECK(contains(error.what(), "version 99"));
  }
}

TEST_CASE("ReportsTellEveryQuantityAndDrawEveryField") {
  for (const app::StoredResult& result : {steady(), over_cycle()}) {
    const std::string page = app::report_html(result);
    CHECK(test::unbalanced_tag(page).empty());
    for (const app::StoredQuantity& q : result.quantities) {
      CHECK(contains(page, "data-quantity=\"" + q.quantity.name + "\""));
    }
    for (const app::StoredValues& field : result.fields) {
      if (field.axes != "phi z" || field.name == "supplied") continue;
      CHECK(contains(page, "aria-label=\"" + field.long_name));
    }
    for (const app::StoredValues& series : result.series) {
      if (series.name == "t" || series.name == "angle") continue;
      CHECK(contains(page, series.long_name));  // drawn, or told to be zero
    }
    CHECK_FALSE(contains(page, "NOT CONVERGED"));
  }
  const bearing::Result ended = test::not_converged(test::synthetic_result());
  const std::string page =
      app::report_html(read_back(app::result_hdf5(test::synthetic_case(), ended)));
  CHECK(contains(page, "NOT CONVERGED"));
  CHECK(contains(page, "not a result"));
}

TEST_CASE("TheFilmForParaViewLiesOnTheBore") {
  const app::StoredResult result = steady();
  const auto files = app::film_vtu(result);
  REQUIRE(files.size() == 1);
  CHECK(files[0].name == "film.vtu");
  CHECK(test::unbalanced_tag(files[0].content.substr(files[0].content.find('\n'))).empty());
  const auto quads = quads_of(files[0].content);
  const FilmGrid& g = result.grid;
  REQUIRE(quads.size() == static_cast<std::size_t>(g.cells()));
  const auto p = array_of(files[0].content, "p [Pa]");
  CHECK(p == result.field("p")->values);
  CHECK(array_of(files[0].content, "T [K]").size() == p.size() * result.s.size());
  double load = 0.0, on_grid = 0.0, chord = 0.0;
  for (int k = 0; k < g.cells(); ++k) {
    const Quad& quad = quads[static_cast<std::size_t>(k)];
    const double phi = g.phi[static_cast<std::size_t>(k / g.nz)];
    // outwards, at the cell's own place
    CHECK(quad.normal[0] * std::cos(phi) + quad.normal[1] * std::sin(phi) > 0.0);
    CHECK(quad.middle[2] == Approx(g.z[static_cast<std::size_t>(k % g.nz)]).margin(1e-12));
    load += p[static_cast<std::size_t>(k)] * quad.normal[1];
    on_grid += p[static_cast<std::size_t>(k)] * g.area(k) * std::sin(phi);
    chord = std::max(chord, g.dphi[static_cast<std::size_t>(k / g.nz)]);
  }
  // A plane cell is shorter than its arc by the square of half its angle over six.
  CHECK(load == Approx(on_grid).epsilon(chord * chord / 24.0 + 1e-12));
}

TEST_CASE("FilmsOfACycleHaveTheirInstants") {
  const app::StoredResult result = over_cycle();
  const auto files = app::film_vtu(result);
  const bearing::CycleResult cycle = test::synthetic_cycle();
  REQUIRE(files.size() == cycle.frames.size() + 2);
  const std::string& list = files.back().content;
  CHECK(files.back().name == "film.pvd");
  for (std::size_t k = 0; k < cycle.frames.size(); ++k) {
    CHECK(contains(list, "file=\"" + files[k + 1].name + "\""));
    CHECK(array_of(files[k + 1].content, "h [m]") == cycle.frames[k].h);
  }
  for (const app::VtuFile& file : files) {
    const test::ScratchFile scratch(file.name);
    app::write_file(scratch.path(), app::marked(app::Format::vtk, file.content));
    CHECK(app::is_result(scratch.path()));
  }
}

TEST_CASE("WhatIsNoResultOfARunIsRefused") {
  const test::ScratchFile scratch("other.h5");
  app::write_file(scratch.path(), "not HDF5");
  CHECK_THROWS_AS(app::read_result(scratch.path()), InputError);
  CHECK_THROWS_AS(app::read_result(scratch.path() + ".nosuch"), FileError);
  app::StoredResult no_film;
  no_film.tier = "estimate";
  CHECK_THROWS_AS(app::film_vtu(no_film), InputError);
  // A file cut short, as a full disk or a broken copy leaves it.
  const std::string bytes = app::result_hdf5(test::synthetic_case(), test::synthetic_result());
  app::write_file(scratch.path(), bytes.substr(0, bytes.size() / 2));
  CHECK_THROWS(app::read_result(scratch.path()));
}
