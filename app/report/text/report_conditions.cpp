// The section on senses, devices and noise: what the protocol requests, next to what the sessions store.

#include <algorithm>
#include <map>
#include <set>

#include "app/findings/outcome/display_number.h"
#include "app/report/text/report_sections.h"
#include "app/words/text_parts.h"

namespace asperity {

namespace {

using NoiseSource = RecordedNoise::Source;

std::string levels_dBA_text(const std::set<double>& levels_dBA) {
  const std::string lowest = display_number(*levels_dBA.begin());
  return (levels_dBA.size() == 1 ? lowest
                                 : lowest + " to " + display_number(*levels_dBA.rbegin())) +
         " dB(A)";
}

/// " (level at the ear, as measured: 65 dB(A))"
std::string played_level_text(const ReportFacts& facts, const SessionShare& played) {
  std::set<double> levels_dBA{};
  const SessionShare measured =
      share_of_sessions(facts, [&levels_dBA](const RecordedStretch& stretch) {
        const bool is = stretch.noise.source == NoiseSource::program && stretch.noise.measured_dBA;
        if (is) levels_dBA.insert(*stretch.noise.measured_dBA);
        return is;
      });
  if (!measured.is_any()) return " (level at the ear not measured)";
  const std::string where =
      measured.whole == played.whole && measured.part == played.part ? "" : ' ' + measured.text();
  return " (level at the ear, as measured" + where + ": " + levels_dBA_text(levels_dBA) + ')';
}

/// "A. Keller measured 65 dB(A) at the ear"
std::string attested_text(const ReportFacts& facts) {
  std::set<std::string> people{};
  std::set<double> levels_dBA{};
  for (const ReportedSession& session : facts.sessions) {
    for (const RecordedStretch& stretch : session.stretches) {
      if (stretch.noise.source != NoiseSource::elsewhere) continue;
      people.insert(stretch.noise.verified_by);
      levels_dBA.insert(*stretch.noise.measured_dBA);
    }
  }
  return listed({people.begin(), people.end()}) + " measured " + levels_dBA_text(levels_dBA) +
         " at the ear";
}

std::string requested_noise_text(const Protocol& protocol) {
  const Protocol::Noise& noise = protocol.masking_noise;
  if (noise.kind == Protocol::Noise::Kind::none) return "The protocol requests no masking noise. ";
  return std::string("The protocol requests ") +
         (noise.kind == Protocol::Noise::Kind::pink ? "pink" : "white") + " noise" +
         (noise.level_dBA ? " of " + display_number(*noise.level_dBA) + " dB(A) at the ear" : "") +
         " to mask the sound of the device. ";
}

std::string noise_text(const ReportFacts& facts) {
  return (facts.file.protocol ? requested_noise_text(*facts.file.protocol) : "") +
         recorded_noise_text(facts);
}

std::string vision_text(const ReportFacts& facts) {
  const SessionShare masked = share_of_sessions(
      facts, [](const RecordedStretch& stretch) { return stretch.eye_mask_confirmed; });
  const std::string confirmed = " Its use was confirmed " + masked.text() + '.';
  const SessionShare unconfirmed = share_of_sessions(
      facts, [](const RecordedStretch& stretch) { return !stretch.eye_mask_confirmed; });
  if (!facts.file.protocol) return masked.is_any() ? "An eye mask was used." + confirmed : "";
  switch (facts.file.protocol->vision) {
    case Vision::free:
      return "The protocol requests neither an eye mask nor that the hand be out of view.";
    case Vision::hand_occluded:
      return "The protocol requests that the hand be out of view; compliance with this is not "
             "recorded.";
    case Vision::blindfold:
      break;
  }
  return "The protocol requests an eye mask while surfaces are explored." +
         (masked.is_any() ? confirmed : "") +
         (unconfirmed.is_any()
              ? " Whether one was worn is not recorded " + unconfirmed.text_after_not() + '.'
              : "");
}

/// The devices of sessions with at least so many attempts that analyses include.
std::set<std::string> distinct_devices(const ReportFacts& facts, std::size_t counted_attempts) {
  std::set<std::string> devices{};
  for (const ReportedSession& session : facts.sessions) {
    if (session.counted_attempts < counted_attempts) continue;
    for (const RecordedStretch& stretch : session.stretches) devices.insert(stretch.device.text);
  }
  return devices;
}

std::string devices_text(const ReportFacts& facts) {
  const std::string devices = devices_in(facts);
  std::string text = devices.empty() ? "" : "Device: " + devices + '.';
  if (distinct_devices(facts, 1).size() > 1) {
    text += " The analyses pool the sessions on different devices.";
  }
  return text;
}

ReportList resumed_elsewhere(const ReportFacts& facts) {
  ReportList list{};
  for (const ReportedSession& session : facts.sessions) {
    std::vector<std::string> devices{};
    for (const RecordedStretch& stretch : session.stretches) {
      const std::string device = stretch.device.full_text();
      if (devices.empty() || devices.back() != device) devices.push_back(device);
    }
    if (devices.size() < 2) continue;
    std::string text = "Session " + std::to_string(session.row.session) + " of " +
                       session.row.participant + " began on " + devices.front();
    for (std::size_t i = 1; i < devices.size(); ++i) text += ", then was resumed on " + devices[i];
    list.items.push_back(text + '.');
  }
  return list;
}

}  // namespace

std::string recorded_noise_text(const ReportFacts& facts) {
  const auto share = [&facts](NoiseSource source) {
    return share_of_sessions(
        facts, [source](const RecordedStretch& stretch) { return stretch.noise.source == source; });
  };
  std::vector<std::string> sentences{};
  if (const SessionShare played = share(NoiseSource::program); played.is_any()) {
    sentences.push_back("The program played masking noise " + played.text() +
                        played_level_text(facts, played) + '.');
  }
  if (const SessionShare elsewhere = share(NoiseSource::elsewhere); elsewhere.is_any()) {
    sentences.push_back("Masking noise came from another source " + elsewhere.text() + ": " +
                        attested_text(facts) + '.');
  }
  if (const SessionShare silent = share(NoiseSource::not_played); silent.is_any()) {
    sentences.push_back("No masking noise was played " + silent.text_after_not() + '.');
  }
  if (const SessionShare unknown = share(NoiseSource::not_recorded); unknown.is_any()) {
    sentences.push_back("Whether masking noise was played is not recorded " +
                        unknown.text_after_not() + '.');
  }
  std::string text{};
  for (const std::string& sentence : sentences) text += (text.empty() ? "" : " ") + sentence;
  return text;
}

std::string unfelt_force_text(const ReportFacts& facts) {
  std::string text{};
  for (const std::string hand : {"virtual", "recorded"}) {
    const SessionShare held = share_of_sessions(facts, [&hand](const RecordedStretch& stretch) {
      return stretch.device.hand_of_program() == hand;
    });
    if (!held.is_any()) continue;
    text += (text.empty() ? "A " : " A ") + hand + " hand moved the device " + held.text() +
            ": no participant moved a device or felt a force there.";
  }
  if (const SessionShare weak = share_of_sessions(facts, gives_no_force); weak.is_any()) {
    text += (text.empty() ? "" : " ") + std::string("A device without motors was used ") +
            weak.text() +
            ": forces were computed but not exerted, and no participant felt the surfaces there.";
  }
  return text;
}

std::string devices_in(const ReportFacts& facts) {
  const std::set<std::string> devices = distinct_devices(facts, 0);
  std::string text{};
  for (const std::string& device : devices) {
    const SessionShare share = share_of_sessions(
        facts, [&device](const RecordedStretch& stretch) { return stretch.device.text == device; });
    const bool is_only = devices.size() == 1 && share.whole == share.all;
    text += (text.empty() ? "" : "; ") + device + (is_only ? "" : " (" + share.text() + ')');
  }
  return text;
}

bool is_moved_by_program(const RecordedStretch& stretch) {
  return !stretch.device.hand_of_program().empty();
}

bool gives_no_force(const RecordedStretch& stretch) { return stretch.device.has_motors == false; }

SessionShare share_of_sessions(const ReportFacts& facts,
                               const std::function<bool(const RecordedStretch&)>& is_so) {
  SessionShare share{};
  for (const ReportedSession& session : facts.sessions) {
    const auto count = static_cast<std::size_t>(
        std::count_if(session.stretches.begin(), session.stretches.end(), is_so));
    ++share.all;
    if (count == 0) continue;
    ++(count == session.stretches.size() ? share.whole : share.part);
  }
  return share;
}

std::string SessionShare::text() const {
  const std::string of_all = all == 1 ? "the only session" : display_count(all) + " sessions";
  if (whole == all)
    return all == 1 ? "in " + of_all : all == 2 ? "in both sessions" : "in all " + of_all;
  const auto counted = [&](std::size_t count) {
    return all == 1 ? of_all : display_count(count) + " of " + of_all;
  };
  if (whole == 0) return "in part of " + counted(part);
  return "in " + counted(whole) +
         (part == 0 ? "" : " and in part of " + count_in_words(part) + " more");
}

std::string SessionShare::text_after_not() const {
  if (whole < all || all == 1) return text();
  return all == 2 ? "in either session" : "in any of the " + display_count(all) + " sessions";
}

ReportSection conditions_section(const ReportFacts& facts) {
  ReportSection section{"Apparatus and conditions", {}};
  const bool has_people = facts.group != AnswerGroup::virtual_participants;
  std::string device = devices_text(facts);
  if (const std::string unfelt = has_people ? unfelt_force_text(facts) : ""; !unfelt.empty()) {
    device += (device.empty() ? "" : " ") + unfelt;
  }
  if (!device.empty()) section.parts.emplace_back(ReportText{device});
  ReportList elsewhere = resumed_elsewhere(facts);
  if (!elsewhere.items.empty()) section.parts.emplace_back(std::move(elsewhere));
  if (!has_people) {
    section.parts.emplace_back(ReportText{"Virtual participants neither see nor hear."});
    return section;
  }
  const std::string noise = noise_text(facts);
  if (!noise.empty()) section.parts.emplace_back(ReportText{noise});
  const std::string vision = vision_text(facts);
  if (!vision.empty()) section.parts.emplace_back(ReportText{vision});
  return section;
}

}  // namespace asperity
