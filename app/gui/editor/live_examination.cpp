// Requests an examination from the shared examiner after a pause, and withdraws an outdated request.

#include "app/gui/editor/live_examination.h"

#include <utility>

namespace asperity {

namespace {

constexpr int kExaminePause_ms = 1500;  // longer than between two changes of a line

}  // namespace

LiveExamination::LiveExamination(StimulusExaminer& examiner, QObject* parent)
    : QObject(parent), examiner_(examiner) {
  pause_.setSingleShot(true);
  pause_.setInterval(kExaminePause_ms);
  connect(&pause_, &QTimer::timeout, this, &LiveExamination::begin);
  connect(&examiner_, &StimulusExaminer::held_changed, this, [this] {
    if (is_under_way_) emit changed();
  });
}

void LiveExamination::want(std::shared_ptr<const Protocol> protocol) {
  abandon();
  protocol_ = std::move(protocol);
  pause_.start();
}

void LiveExamination::abandon() {
  pause_.stop();
  examiner_.withdraw(this);
  is_under_way_ = false;
  result_.reset();
}

void LiveExamination::begin() {
  is_under_way_ = true;
  examiner_.request(this, {protocol_},
                    [this](const Protocol&, const StimulusExaminer::Result& result) {
                      is_under_way_ = false;
                      result_ = result;
                      emit changed();
                    });
  emit changed();
}

}  // namespace asperity

#include "moc_live_examination.cpp"
