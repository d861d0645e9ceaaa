// A list of options in words, in columns, on as many pages as it takes.

#pragma once

#include <vector>

#include <QtCore/QString>

#include "app/gui/participant/pages/participant_item.h"

namespace asperity {

class PageFrame;

struct ListedOption {
  QString text{};
  QString key{};  ///< that chooses it
  bool pointed_at = false;
};
struct OptionList {
  QString question{};                   ///< over the options
  std::vector<ListedOption> options{};  ///< pressed as What::choose
  std::vector<int> chosen{};            ///< from 1; the first determines the page of the picture
};
void lay_out_options(PageFrame& frame, const OptionList& list);

/// The options of the scene, which are words.
std::vector<ListedOption> options_in_words(const ParticipantScene& scene);
/// The places of the chosen options of the scene, from 1.
std::vector<int> chosen_options(const ParticipantScene& scene);

}  // namespace asperity
