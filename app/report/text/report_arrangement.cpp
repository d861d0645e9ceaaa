// Describes each arrangement of surfaces, and names the blocks where they differ.

#include "app/report/text/report_arrangement.h"

#include <cctype>

#include "analysis/numbers/number_text.h"
#include "app/findings/outcome/display_number.h"
#include "app/words/text_parts.h"
#include "protocols/design/block_factors.h"
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

/// The verbs of one tense.
struct Verbs {
  const char* is;
  const char* are;
  const char* lie;
  const char* move;
  const char* choose;
  const char* has_to_be;
  const char* ends;
  const char* can_be;
  const char* cannot;
};
constexpr Verbs kPresent{"is",        "are",  "lie",    "move",  "choose",
                         "has to be", "ends", "can be", "cannot"};
constexpr Verbs kPast{"was",       "were",  "lay",      "moved",    "chose",
                      "had to be", "ended", "could be", "could not"};

/// Whether another sentence names the arrangement.
bool is_named_with_task(const Protocol::Block& block) {
  return judged_question(block) != nullptr && block.vary.has_value();
}

/// Of surfaces that are presented once each.
std::string one_visit_sentence(const Protocol::Block& block, const Verbs& verbs) {
  const std::size_t surfaces = block.all_pairs ? 2 : block.presented.size();
  if (surfaces < 2 || is_named_with_task(block)) return {};
  return std::string(" The surfaces of a trial ") + verbs.are + " presented one after " +
         (surfaces == 2 ? "the other." : "another.");
}

std::string order_sentences(const Protocol::Block& block, const Verbs& verbs) {
  const Arrangement& arrangement = block.arrangement;
  switch (arrangement.surfaces) {
    case Arrangement::Surfaces::sequential:
      if (arrangement.minimum_visits == 1) return one_visit_sentence(block, verbs);
      return std::string(" The surfaces ") + verbs.are + " presented in the same order " +
             number_of_times(arrangement.minimum_visits) + " in each trial.";
    case Arrangement::Surfaces::side_by_side:
      return " The surfaces " +
             (is_named_with_task(block) ? verbs.are + std::string(" separated")
                                        : verbs.lie + std::string(" side by side, separated")) +
             " by a flat gap of " + number_text(1000.0 * arrangement.gap_m) +
             " mm, and participants " + verbs.move + " freely over them; each " + verbs.has_to_be +
             " visited at least " + number_of_times(arrangement.minimum_visits) + ".";
    case Arrangement::Surfaces::on_request:
      return std::string(" Participants ") + verbs.choose + " which surface to feel next; each " +
             verbs.has_to_be + " felt at least " + number_of_times(arrangement.minimum_visits) +
             ".";
  }
  return {};
}

std::string interval_sentence(const Arrangement& arrangement, const Verbs& verbs) {
  const Arrangement::Interval& interval = *arrangement.interval;
  const std::string from_to =
      " The interval from the last contact with a surface to the permission to touch the next one ";
  if (interval.shortest_s == interval.longest_s) {
    // A participant who requests a surface may take longer.
    const bool is_least = arrangement.allows_revisits();
    return from_to + verbs.is + (is_least ? " at least " : " ") + seconds(interval.shortest_s) +
           ".";
  }
  return from_to + verbs.is + " drawn between " + seconds(interval.shortest_s) + " and " +
         seconds(interval.longest_s) + ".";
}

std::string roving_sentence(const std::string& what, const std::vector<double>& levels,
                            const std::string& unit, const Verbs& verbs, double scale) {
  if (levels.empty()) return {};
  std::vector<std::string> texts{};
  for (const double level : levels) texts.push_back(number_text(scale * level));
  return " The " + what + ' ' + verbs.is + " drawn for each presentation from " + listed(texts) +
         unit + ".";
}

std::string sentences_on(const Protocol::Block& block, const Verbs& verbs) {
  const Arrangement& arrangement = block.arrangement;
  std::string text = order_sentences(block, verbs);
  if (arrangement.interval) text += interval_sentence(arrangement, verbs);
  const auto after = [&verbs](const std::string& end) {
    return std::string(" A visit ") + verbs.ends + " after " + end + ".";
  };
  if (arrangement.strokes) {
    text += after(std::to_string(*arrangement.strokes) +
                  (*arrangement.strokes == 1 ? " stroke" : " strokes"));
  }
  if (arrangement.contact_s) text += after("a contact of " + seconds(*arrangement.contact_s));
  if (arrangement.surfaces == Arrangement::Surfaces::sequential && !arrangement.allows_revisits()) {
    text += std::string(" Participants ") + verbs.cannot + " return to a surface within a trial.";
  } else if (arrangement.maximum_visits) {
    text += std::string(" A surface ") + verbs.can_be + " felt at most " +
            number_of_times(*arrangement.maximum_visits) + ".";
  }
  if (arrangement.draws_phase) {
    text += std::string(" The place on the texture ") + verbs.is + " drawn for each presentation.";
  }
  text += roving_sentence("stiffness", block.rove.stiffness_N_per_m, " N/m", verbs, 1.0);
  text += roving_sentence("friction coefficient", block.rove.friction, "", verbs, 1.0);
  text += roving_sentence("height of the surface", block.rove.raised_m, " mm", verbs, 1000.0);
  return text;
}

}  // namespace

std::string arrangement_sentences(const Protocol::Block& block) {
  std::string text{};
  if (is_named_with_task(block)) {
    text = presentation_text(block).english();
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    text = " Task: " + text + ".";
  }
  return text + sentences_on(block, kPresent);
}

std::string past_arrangement_sentences(const Protocol::Block& block) {
  std::string text = sentences_on(block, kPast);
  if (!text.empty()) text.erase(0, 1);
  return text;
}

std::string friction_text(const std::set<double>& presented, const Protocol& protocol) {
  if (presented.empty()) return number_text(protocol.material.friction);
  if (presented.size() == 1) return number_text(*presented.begin());
  return "between " + number_text(*presented.begin()) + " and " + number_text(*presented.rbegin());
}

std::string stiffness_text(const std::set<double>& presented_N_per_m, const Protocol& protocol) {
  const auto newton_per_metre = [](double stiffness) { return display_quantity(stiffness, "N/m"); };
  if (presented_N_per_m.empty()) return newton_per_metre(protocol.material.stiffness_N_per_m);
  if (presented_N_per_m.size() == 1) return newton_per_metre(*presented_N_per_m.begin());
  return "between " + newton_per_metre(*presented_N_per_m.begin()) + " and " +
         newton_per_metre(*presented_N_per_m.rbegin());
}

}  // namespace asperity
