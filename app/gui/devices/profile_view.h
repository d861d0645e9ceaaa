// What a device was measured to be: each item with its number and limit, and its response.

#pragma once

#include <optional>

#include <QtWidgets/QWidget>

#include "app/profiles/device_profile.h"

class QGridLayout;
class QLabel;

namespace asperity {

class ResponsePlot;
class StateLabel;

/// Of a simulated device that stands for a real one first what is known of that ("profile_known").
///
/// Safety first, then timing, then mechanics: pass, fail or not measured, the number, what it is held to, and
/// below the item what was done, or why nothing could be.
///
/// The labels of an item are called "item_NAME", "result_NAME", "value_NAME", "limit_NAME".
class ProfileView final : public QWidget {
  Q_OBJECT
 public:
  explicit ProfileView(QWidget* parent = nullptr);

  void show_profile(const DeviceProfile& profile);

 private:
  void fill(const DeviceProfile& profile);
  void add_item(const DeviceItem& item);

  QLabel* heading_ = nullptr;
  StateLabel* summary_ = nullptr;
  QLabel* how_ = nullptr;
  QLabel* known_ = nullptr;  ///< of a device that stands for another
  ResponsePlot* response_ = nullptr;
  QWidget* items_ = nullptr;  ///< made anew with every profile
  QGridLayout* grid_ = nullptr;
};

}  // namespace asperity
