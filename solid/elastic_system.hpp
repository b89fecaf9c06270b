#pragma once
/// Stiffness of a body of revolution for one circumferential harmonic, in block tridiagonal form.
///
/// The nodes of the section are put into groups, each a line of corner nodes with the mid-side
/// nodes up to the next line; elements couple a group only to itself and to the line of the next
/// (core/block_cholesky.hpp). Lines run along the axis and follow each other outwards, or they run
/// outwards and follow each other along the axis. The matrix is the same; its factorisation costs
/// the cube of the lines' length, so that a wide thin body is cut along the axis and a shaft most
/// of all. With lines that follow each other outwards, leaving out the last group holds the outer
/// surface; the other way the held nodes are left out of the groups.
#include <array>
#include <vector>

#include "core/block_cholesky.hpp"
#include "core/revolution_mesh.hpp"
#include "solid/elastic_element.hpp"

namespace shellback::solid {

/// How the groups of nodes follow each other.
enum class Elimination {
  cheapest,  ///< as the mesh has it
  outwards,
  along_axis,
};

/// The body: its mesh and one set of element matrices for each distinct element.
struct ElasticBody {
  const RevolutionMesh& mesh;
  bool plane_strain = false;  ///< end faces do not move along the axis
  int loaded_line = 0;        ///< corner line that carries the film
  Elimination order = Elimination::outwards;
  std::vector<ElasticElement> pieces;
  std::vector<int> piece;  ///< of each element, index row * cols + col

  [[nodiscard]] bool solid_core() const { return mesh.r_face.front() == 0.0; }
  /// Tilt is a free rigid motion of harmonic 1.
  [[nodiscard]] bool can_tilt() const { return !mesh.half && !plane_strain; }
};

/// Throws InputError if a material has no valid elastic constants. `factorisations`: how many the
/// order along the axis needs where the order outwards needs one.
[[nodiscard]] ElasticBody make_elastic_body(const RevolutionMesh& mesh,
                                            const std::vector<Material>& layers, bool plane_strain,
                                            int loaded_line, Elimination order, int factorisations);

/// Where each nodal component stands in the blocks.
struct Freedoms {
  std::vector<int> group;     ///< of each node
  std::vector<int> position;  ///< 3 nodes entries: row in the group's block, -1 if held at zero
  std::vector<double> sign;   ///< component = sign * unknown
  std::vector<int> size;      ///< rows of each group's block
  std::vector<int> head;      ///< rows that belong to its corner line
};

/// `first`: rows before it are left out. `hold_outer`: the outermost line does not move.
[[nodiscard]] Freedoms make_freedoms(const ElasticBody& body, int n, int first, bool hold_outer);

struct LocalFreedom {
  int group;
  int position;
  double sign;
};
using LocalFreedoms = std::array<LocalFreedom, 24>;
[[nodiscard]] LocalFreedoms local_freedoms(const ElasticBody& body, const Freedoms& f, int row,
                                           int col);

/// Stiffness of harmonic n from row `first` outwards.
[[nodiscard]] BlockTridiagonal stiffness(const ElasticBody& body, const Freedoms& f, int n,
                                         int first);

}  // namespace shellback::solid
