#include "app/words/plain_note_words.hpp"

namespace shellback::app {
namespace {

using bearing::note::Plain;

std::string beginning_of_event(Plain n) {
  switch (n) {
    case Plain::event_from_steady:
      return "the event begins in the steady state of its first row";
    case Plain::event_at_rest:
      return "the event begins at rest: asperities carry the load of its first row, the film "
             "nothing but what the supplies' pressure presses upon";
    case Plain::event_in_the_middle:
      return "the event begins with the journal at rest in the middle of a full film: its first "
             "row has no load, or no steady state of it was found";
    case Plain::event_without_heat:
      return "walls and film begin at the (first) supply's temperature, before the film has heated "
             "them: no steady state with heat of the event's first row is known (none is where a "
             "drilling feeds)";
    case Plain::event_in_lumps:
      return "the film has one temperature, at which the oil that is fed over the event would "
             "carry off all of its heat; walls take up none (in tier thd they do)";
    default:
      return "the event begins with the journal in the middle of a full film: no steady place "
             "under its first row was found";
  }
}

std::string of_bars(Plain n) {
  switch (n) {
    case Plain::bars_interrupted:
      return "interrupted before the error bars were known";
    case Plain::bars_unknown:
      return "neither a coarser grid nor a finer one gave a solution: the error bars are unknown";
    case Plain::cycle_bars_unknown:
      return "none of the coarser grids that were tried carries this cycle: the bars are not known "
             "(a journal without mass may have to leap on them: load_cycle.journal_mass)";
    case Plain::time_bars_unknown:
      return "with other steps in time the cycle was not found: no bar has what the steps leave "
             "open";
    case Plain::march_bars_unknown:
      return "no coarser grid holds the supplies and passes this run in the same steps: its bars "
             "are not known; a finer grid (model.grid) may have some";
    case Plain::orbit_not_judged:
      return "slow changes from cycle to cycle were led on to the orbit that is told; that a "
             "journal "
             "keeps to it was not seen: displaced from it, it does not pass the cycles that would "
             "tell, or moves in noise (the same load as a single event over many turns shows it)";
    case Plain::nodes_not_judged:
      return "more nodes across the film gave no solution on the coarse grid: what they would "
             "change is in no bar";
    case Plain::nothing_richer:
      return "nothing richer than this physics is there to judge it by: no model bars";
    default:
      return "the case has no data of shell and shaft: what their heat and deformation change is "
             "in no bar";
  }
}

std::string of_model(Plain n) {
  switch (n) {
    case Plain::edge_oil_as_supply:
      return "oil that comes in again at a side edge is as warm as what the supplies feed";
    case Plain::edge_oil_as_film:
      return "oil that comes in again at a side edge is as warm as the film (tiers thd and tehd "
             "take it to be as warm as what the supplies feed)";
    case Plain::layer_keeps_thickness:
      return "the elasto-plastic layer grows as what it lies on: how its own thickness goes with "
             "the mean temperature is left out (2 nm a kelvin for 20 um of polymer)";
    default:
      return "the surfaces are rigid (model.elastic_deformation, or the tier): the elasto-plastic "
             "layer does not yield";
  }
}

}  // namespace

std::string plain_words(Plain n) {
  switch (n) {
    case Plain::orientation_beyond_table:
      return "a roughness orientation lies outside the range 1/9 to 9 of the tabulated flow "
             "factors: the end of the table is used";
    case Plain::pressure_beyond_law:
      return "film pressures leave the range in which the oil's pressure law is known";
    case Plain::marks_begin_anew:
      return "what flows of the elasto-plastic layer begins anew with every worn shape, and is not "
             "in the profile: that holds what has worn away";
    case Plain::nothing_wears:
      return "next to nothing has worn: less than a millionth of the summits' roughness";
    case Plain::roughness_stays:
      return "the roughness is taken to stay while the shell wears (running_in.worn is not given)";
    case Plain::tilt_without_inertia:
      return "the journal's tilt follows the moment without inertia (journal_mass is that of its "
             "path alone)";
    case Plain::supply_temperature_unused:
      return "tier isothermal: the oil has oil.temperature everywhere; the temperature of a supply "
             "is but that at which flows are told by volume (tiers lumped, thd and tehd follow it)";
    case Plain::torque_both_ways:
      return "the journal turns both ways: mean torques are those of one way less those of the "
             "other; what friction takes is the power loss";
    case Plain::planes_overlap:
      return "the mean planes of the rough surfaces overlap where the film is smallest (its height "
             "is negative): asperity contact where it is not computed, a finer grid, or contact "
             "data for surfaces pressed so far";
    case Plain::edge_oil_as_supply:
    case Plain::edge_oil_as_film:
    case Plain::layer_keeps_thickness:
    case Plain::rigid_layer:
      return of_model(n);
    case Plain::event_from_steady:
    case Plain::event_at_rest:
    case Plain::event_in_the_middle:
    case Plain::event_without_heat:
    case Plain::event_in_lumps:
    case Plain::estimate_in_the_middle:
      return beginning_of_event(n);
    case Plain::bars_interrupted:
    case Plain::bars_unknown:
    case Plain::cycle_bars_unknown:
    case Plain::time_bars_unknown:
    case Plain::march_bars_unknown:
    case Plain::orbit_not_judged:
    case Plain::nodes_not_judged:
    case Plain::nothing_richer:
    case Plain::walls_not_judged:
      return of_bars(n);
    case Plain::estimate_of_cycle:
      return "estimate: rigid circular bearing whose film is full wherever it closes (Booker's "
             "mobility, table of the finite bearing), one temperature from the heat of a mean "
             "cycle in lumps";
    case Plain::estimate_vessel_open:
      return "estimate: supplies with a vessel are taken as always open";
    case Plain::estimate_drilling:
      break;
  }
  return "estimate: a drilling feeds the flow out of the edges; the film does not feel its mouth";
}

}  // namespace shellback::app
