/// Every format tells that Shellback wrote it, and its readers do not mind.
#include "app/result_mark.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/pictures/svg_comparison.hpp"
#include "app/pictures/write_png.hpp"
#include "app/provenance.hpp"
#include "app/write_coefficients.hpp"
#include "app/write_hdf5.hpp"
#include "app/write_html.hpp"
#include "app/write_json.hpp"
#include "tests/app_output/markup.hpp"
#include "tests/app_output/synthetic.hpp"

using namespace shellback;
using app::Format;
using app::marked;

namespace {

bool is_result(const std::string& content) {
  const test::ScratchFile scratch("marked");
  std::ofstream(scratch.path(), std::ios::binary) << content;
  return app::is_result(scratch.path());
}

std::uint32_t number_at(const std::string& bytes, std::size_t at) {
  std::uint32_t x = 0;
  for (std::size_t k = 0; k < 4; ++k) x = (x << 8U) | static_cast<unsigned char>(bytes[at + k]);
  return x;
}

/// Remainder of the chunk's polynomial by that of ISO/IEC 15948, annex D, bit by bit.
std::uint32_t checksum(const std::string& bytes, std::size_t begin, std::size_t size) {
  std::uint32_t crc = 0xFFFFFFFFU;
  for (std::size_t k = 8 * begin; k < 8 * (begin + size); ++k) {
    const std::uint32_t bit = (static_cast<unsigned char>(bytes[k / 8]) >> (k % 8)) & 1U;
    crc = (crc >> 1U) ^ (((crc ^ bit) & 1U) * 0xEDB88320U);
  }
  return ~crc;
}

}  // namespace

TEST_CASE("EveryFormatIsKnownAsAResult") {
  const auto c = test::synthetic_case();
  const auto comparison = test::synthetic_comparison();
  const std::string svg = app::comparison_svg(c, comparison);
  CHECK(is_result(marked(Format::hdf5, app::result_hdf5(c, test::synthetic_result()))));
  CHECK(is_result(marked(Format::json, app::comparison_json(c, comparison))));
  CHECK(is_result(marked(Format::html, app::comparison_html(c, comparison))));
  CHECK(is_result(marked(Format::svg, svg)));
  CHECK(is_result(marked(Format::png, app::png_of(svg))));
  CHECK(is_result(marked(Format::vtk, "<?xml version=\"1.0\"?>\n<VTKFile/>\n")));
  CHECK_FALSE(is_result("<?xml version=\"1.0\"?>\n<VTKFile/>\n"));
  CHECK(is_result(marked(Format::markdown, "# Map\n")));
  CHECK(is_result(marked(Format::csv, "a,b\n1,2\n")));
  bearing::Coefficients k;
  k.omega = -314.159;
  k.K = {{{1.5e8, -2.0}, {0.0, 3e-7}}};
  CHECK(is_result(marked(Format::coefficients, app::coefficients_csv({k}))));
  CHECK(is_result(marked(Format::coefficients, app::coefficients_csv({k, k, k}))));
  CHECK(is_result(app::coefficients_csv(std::vector(2000, k))));  // longer than what is looked at
  CHECK_FALSE(is_result(app::coefficients_csv({})));
  CHECK_FALSE(is_result(app::coefficients_csv({k}) + "1,2,3,4,5,6,7,8,9\n"));  // of another hand
}

TEST_CASE("FilesOfOthersAreNotTakenForResults") {
  CHECK_FALSE(is_result("title = \"a case\"\n"));
  CHECK_FALSE(is_result("phi [deg],z [mm],height [um]\n0,0,1\n"));
  CHECK_FALSE(is_result("{\"mine\": true}\n"));
  CHECK_FALSE(is_result("<!DOCTYPE html>\n<p>about Shellback</p>\n"));
  CHECK_FALSE(is_result("<svg xmlns=\"http://www.w3.org/2000/svg\"/>\n"));
  CHECK_FALSE(is_result("\x89HDF\r\n\x1a\n and no more of it"));
  CHECK_FALSE(
      is_result(app::png_of("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" "
                            "height=\"9\"/>")));
  // Somebody's own table for rotordynamics: other digits, more rows.
  CHECK_FALSE(is_result("frequency,kxx,kxy,kyx,kyy,cxx,cxy,cyx,cyy\n1,2,3,4,5,6,7,8,9\n"));
  CHECK_FALSE(is_result(""));
}

TEST_CASE("TheMarkedJsonIsTheSameAndNamesItsGenerator") {
  const std::string plain =
      app::comparison_json(test::synthetic_case(), test::synthetic_comparison());
  auto json = nlohmann::json::parse(marked(Format::json, plain));
  CHECK(json.at("generator").get<std::string>() ==
        "Shellback " + app::provenance(bearing::Case{}).version);
  json.erase("generator");
  CHECK(json == nlohmann::json::parse(plain));
}

TEST_CASE("TheMarkedTableGetsALastColumnAndKeepsItsLines") {
  const std::string version = app::provenance(bearing::Case{}).version;
  CHECK(marked(Format::csv, "a,b\n1,\"two\nlines\"\n3,4\n") ==
        "a,b,shellback\n1,\"two\nlines\"," + version + "\n3,4," + version + "\n");
}

TEST_CASE("TheTextChunkOfAPngHasItsLengthAndChecksum") {
  constexpr std::size_t kHeader = 8;           // behind the signature
  constexpr std::size_t kText = kHeader + 25;  // behind the header chunk
  constexpr std::size_t kFrame = 12;           // length, name and checksum of a chunk
  const std::string plain =
      app::png_of("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\"/>");
  const std::string png = marked(Format::png, plain);
  const std::size_t length = number_at(png, kText);
  CHECK(png.size() == plain.size() + length + kFrame);
  CHECK(png.substr(kText + 4, 4) == "tEXt");
  // The header's checksum, written by the PNG library, proves the function used for the other.
  CHECK(number_at(png, kText - 4) == checksum(png, kHeader + 4, 4 + 13));
  CHECK(number_at(png, kText + 8 + length) == checksum(png, kText + 4, 4 + length));
  CHECK(png.substr(kText + length + kFrame) == plain.substr(kText));
}

TEST_CASE("CommentsOfATableStayAsTheyAre") {
  const std::string table = marked(Format::csv, "# 8\" pipe\na,b\n1,2\n# c \"x\n3,4\n");
  CHECK(table.starts_with("# 8\" pipe\na,b,shellback\n1,2,"));
  CHECK(table.find("\n# c \"x\n3,4,") != std::string::npos);
}
