// A list of options in words, in columns, on as many pages as it takes.

#pragma once

#include <optional>
#include <vector>

#include <QtCore/QString>

#include "app/gui/participant/pages/participant_item.h"

namespace asperity {

class PageFrame;

struct OptionList {
  QString question{};              ///< over the options
  std::vector<QString> options{};  ///< pressed as What::choose
  std::vector<int> chosen{};       ///< from 1; the first determines the page of the picture
};
void lay_out_options(PageFrame& frame, const OptionList& list);

/// What is pressed for an option of a list: "1" … "9", then "A" ….
QString key_of_listed_option(int number);
/// The choice of one of `count` options by its key.
std::optional<ParticipantAction> key_of_option_list(const QString& typed, int count);

}  // namespace asperity
