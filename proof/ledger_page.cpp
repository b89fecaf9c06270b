#include "proof/ledger_page.hpp"
namespace shellback::proof {
std::string ledger_page(const std::vector<EntryReport>&, const std::vector<UnrunDataset>&) { return {}; }
}
