// Defines the pages of a form for a protocol.

#include "protocols/form/form_pages.h"

#include <algorithm>
#include <array>
#include <vector>

#include "protocols/design/json_pointer.h"
#include "protocols/shapes/key.h"

namespace asperity {

namespace {

// Which trials a block has, and in which order.
constexpr std::array<std::string_view, 19> kTrialsOfBlock{"crossed",
                                                          "listed",
                                                          "exclude",
                                                          "derived",
                                                          "drawn",
                                                          "repetitions",
                                                          "repetitions_of",
                                                          "all_pairs",
                                                          "anchor",
                                                          "anchor_pair",
                                                          "anchor_at",
                                                          "order",
                                                          "maximum_in_a_row",
                                                          "minimum_distance",
                                                          "fixed_positions",
                                                          "positions",
                                                          "until",
                                                          "pause_before_trial_s",
                                                          "pause_between_surfaces_s"};

constexpr std::array<PagePart, 9> kQuestion{{{"title"},
                                             {"description"},
                                             {"kind"},
                                             {"design"},
                                             {"realism_standard"},
                                             {"name"},
                                             {"version"},
                                             {"authors"},
                                             {"license"}}};
constexpr std::array<PagePart, 6> kSurfaces{
    {{"textures"}, {"bodies"}, {"stimuli"}, {"factors"}, {"material"}, {"surface"}}};
constexpr std::array<PagePart, 3> kTask{
    {{"blocks", kTrialsOfBlock, true}, {"explorations"}, {"estimation"}}};
constexpr std::array<PagePart, 5> kOrder{{{"flow"},
                                          {"blocks", kTrialsOfBlock},
                                          {"counterbalance"},
                                          {.key = "groups", .is_in_title = true},
                                          {"resume"}}};
constexpr std::array<PagePart, 4> kParticipant{
    {{.key = "participants", .is_in_title = true}, {"consent"}, {"questions"}, {"environment"}}};
constexpr std::array<PagePart, 1> kTexts{{{"language"}}};
constexpr std::array<PagePart, 3> kDevice{
    {{.key = "device", .is_in_title = true}, {"instability"}, {"recording"}}};
constexpr std::array<PagePart, 1> kObserver{{{"observer"}}};
constexpr std::array<PagePart, 1> kAnalysis{{{.key = "analysis", .is_in_title = true}}};

constexpr std::array<FormPage, 9> kPages{{
    {"question", "Question", "What the experiment asks, and how the protocol is cited.", kQuestion},
    {"surfaces", "Surfaces", "What is felt, and in what the surfaces differ.", kSurfaces},
    {"task", "Task", "What participants do in a trial, and how they explore a surface.", kTask},
    {"order", "Order and groups",
     "The course of a session, the trials of its blocks, and the groups of participants.", kOrder},
    {"participant", "Participant",
     "Who takes part, what is asked of a participant, and what can be seen and heard.",
     kParticipant},
    {"texts", "Texts", "The texts that participants read, in the order of the file.", kTexts, true},
    {"device", "Device", "The device, its limits, and what is recorded.", kDevice},
    {"observer", "Virtual participants", "How simulated participants respond.", kObserver},
    {"analysis", "Analysis", "The tests and measures that were decided before the data exist.",
     kAnalysis},
}};

constexpr std::array<std::string_view, 2> kOfFiles{"$schema", "format"};

/// The first keys of a pointer: "blocks", "main", "order" of "/blocks/main/order".
std::vector<std::string_view> keys_in(std::string_view pointer) {
  std::vector<std::string_view> keys{};
  while (pointer.starts_with('/')) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    keys.push_back(pointer.substr(0, end));
    pointer.remove_prefix(end);
  }
  return keys;
}

}  // namespace

std::span<const FormPage> form_pages() { return kPages; }

std::span<const std::string_view> keys_of_files() { return kOfFiles; }

bool has_key(const PagePart& part, std::string_view key) {
  if (part.of_entries.empty()) return true;
  const bool is_listed =
      std::find(part.of_entries.begin(), part.of_entries.end(), key) != part.of_entries.end();
  return is_listed != part.are_left_out;
}

const FormPage& form_page_of(std::string_view pointer) {
  constexpr std::size_t kKeyOfEntry = 2;
  const std::vector<std::string_view> keys = keys_in(pointer);
  const FormPage* of_part = nullptr;  // the first page with the key of the protocol
  for (const FormPage& page : kPages) {
    for (const PagePart& part : page.parts) {
      if (keys.empty() || part.key != keys.front()) continue;
      if (of_part == nullptr) of_part = &page;
      if (keys.size() > kKeyOfEntry && has_key(part, keys[kKeyOfEntry])) return page;
    }
  }
  return of_part == nullptr ? kPages.front() : *of_part;
}

}  // namespace asperity
