// Compares each complaint with the last one, and limits how often other words are reported.

#include "app/session/rig/device_complaints.h"

namespace asperity {

bool DeviceComplaints::is_due(std::int64_t now_ns) const noexcept {
  return !heard_ns_ || now_ns - *heard_ns_ >= kHeardEvery_ns;
}

DeviceComplaints::News DeviceComplaints::hear(const std::string& complaint, std::int64_t now_ns) {
  heard_ns_ = now_ns;
  News news{.is_new = complaint != heard_, .turns = complaint.empty() != heard_.empty()};
  heard_ = complaint;
  if (heard_ == told_) return news;
  const bool has_only_other_words = !heard_.empty() && !told_.empty();
  if (has_only_other_words && now_ns - told_ns_ < kToldEvery_ns) return news;
  told_ = heard_;
  told_ns_ = now_ns;
  news.is_to_tell = true;
  return news;
}

}  // namespace asperity
