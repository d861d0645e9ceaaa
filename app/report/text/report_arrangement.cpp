#include "app/report/text/report_arrangement.h"

#include <cctype>

#include "analysis/number_text.h"
#include "app/findings/reading_number.h"
#include "app/words/text_parts.h"
#include "protocols/kinds/experiment_kind.h"
#include "protocols/plan/block_design.h"

namespace asperity {

namespace {

std::string seconds(double time_s) { return number_text(time_s) + " s"; }

std::string number_of_times(int count) {
  return count == 1   ? std::string("once")
         : count == 2 ? std::string("twice")
                      : std::to_string(count) + " times";
}

std::string order_sentences(const Arrangement& arrangement) {
  switch (arrangement.surfaces) {
    case Arrangement::Surfaces::sequential:
      if (arrangement.minimum_visits == 1) return {};
      return " The surfaces are presented in the same order " +
             number_of_times(arrangement.minimum_visits) + " in each trial.";
    case Arrangement::Surfaces::side_by_side:
      return " The surfaces lie side by side, separated by a flat gap of " +
             number_text(1000.0 * arrangement.gap_m) +
             " mm, and participants move freely over them; each has to be visited at least " +
             number_of_times(arrangement.minimum_visits) + ".";
    case Arrangement::Surfaces::on_request:
      return " Participants choose which surface to feel next; each has to be felt at least " +
             number_of_times(arrangement.minimum_visits) + ".";
  }
  return {};
}

std::string interval_sentence(const Arrangement& arrangement) {
  const Arrangement::Interval& interval = *arrangement.interval;
  const std::string from_to =
      " The interval from the last contact with a surface to the permission to touch the next one ";
  if (interval.shortest_s == interval.longest_s) {
    // A participant who requests a surface may take longer.
    const bool is_least = arrangement.allows_revisits();
    return from_to + (is_least ? "is at least " : "is ") + seconds(interval.shortest_s) + ".";
  }
  return from_to + "is drawn between " + seconds(interval.shortest_s) + " and " +
         seconds(interval.longest_s) + ".";
}

std::string roving_sentence(const std::string& what, const std::vector<double>& levels,
                            const std::string& unit, double scale) {
  if (levels.empty()) return {};
  std::vector<std::string> texts{};
  for (const double level : levels) texts.push_back(number_text(scale * level));
  return " The " + what + " is drawn for each presentation from " + listed(texts) + unit + ".";
}

}  // namespace

std::string arrangement_sentences(const Protocol::Block& block) {
  const Arrangement& arrangement = block.arrangement;
  std::string text{};
  if (kind_of(block).has_judgement && block.vary) {
    text = presentation_text(arrangement);
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    text = " Task: " + text + ".";
  }
  text += order_sentences(arrangement);
  if (arrangement.interval) text += interval_sentence(arrangement);
  if (arrangement.strokes) {
    text += " A visit ends after " + std::to_string(*arrangement.strokes) +
            (*arrangement.strokes == 1 ? " stroke." : " strokes.");
  }
  if (arrangement.contact_s) {
    text += " A visit ends after a contact of " + seconds(*arrangement.contact_s) + ".";
  }
  if (arrangement.surfaces == Arrangement::Surfaces::sequential && !arrangement.allows_revisits()) {
    text += " Participants cannot return to a surface within a trial.";
  } else if (arrangement.maximum_visits) {
    text += " A surface can be felt at most " + number_of_times(*arrangement.maximum_visits) + ".";
  }
  if (arrangement.draws_phase) {
    text += " The place on the texture is drawn for each presentation.";
  }
  text += roving_sentence("stiffness", block.rove.stiffness_N_per_m, " N/m", 1.0);
  text += roving_sentence("friction coefficient", block.rove.friction, "", 1.0);
  text += roving_sentence("height of the surface", block.rove.raised_m, " mm", 1000.0);
  return text;
}

std::string stiffness_text(const std::set<double>& presented_N_per_m, const Protocol& protocol) {
  const auto newton_per_metre = [](double stiffness) { return reading_quantity(stiffness, "N/m"); };
  if (presented_N_per_m.empty()) return newton_per_metre(protocol.material.stiffness_N_per_m);
  if (presented_N_per_m.size() == 1) return newton_per_metre(*presented_N_per_m.begin());
  return "between " + newton_per_metre(*presented_N_per_m.begin()) + " and " +
         newton_per_metre(*presented_N_per_m.rbegin());
}

}  // namespace asperity
