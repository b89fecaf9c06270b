/// Input decks of a layered ring for CalculiX, and its answers as rows of a table.
///
///   layered_ring deck pressure|heat THICKNESS_UM POISSON coarse|fine C3D20|C3D20R > DECK.inp
///   layered_ring rows (the same words)                        < DECK.dat > ROWS.csv
///
/// scripts/calculix-reference makes the whole table of validation/layered-ring.
#include <cstdio>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

#include "validation/calculix/ring.hpp"

namespace {

using namespace shellback::calculix;

Ring read_ring(const std::vector<std::string>& word) {
  Ring ring;
  ring.load = word[1] == "heat" ? Load::heat : Load::pressure;
  ring.thickness = std::stod(word[2]) * 1e-6;
  ring.poisson_ratio = std::stod(word[3]);
  ring.fine = word[4] == "fine";
  ring.reduced = word[5] == "C3D20R";
  return ring;
}

}  // namespace

int main(int count, char** words) {
  const std::vector<std::string> word(words + 1, words + count);
  try {
    if (word.size() == 6 && word[0] == "deck") {
      write_deck(read_ring(word));
      return 0;
    }
    if (word.size() == 6 && word[0] == "rows") {
      write_rows(read_ring(word), std::cin);
      return 0;
    }
    std::fprintf(stderr,
                 "usage: layered_ring deck|rows pressure|heat THICKNESS_UM POISSON "
                 "coarse|fine C3D20|C3D20R\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
  }
  return 2;
}
