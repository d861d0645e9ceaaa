// Keeps a queue of requests by page; a background task examines one protocol at a time.

#include "app/gui/base/stimulus_examiner.h"

#include <algorithm>
#include <utility>

#include <QtCore/QPointer>

#include "app/session/rehearsal/rehearsal_memory.h"

namespace asperity {

StimulusExaminer::StimulusExaminer(std::filesystem::path study, const ModelRegistry& models)
    : study_(std::move(study)),
      examine_([&models, folder = study_](const Protocol& protocol, const std::stop_token& stop) {
        StimulusBuilder builder(models, folder);
        return examine_stimuli({protocol, {}}, folder, builder, {.stop = stop});
      }) {
  connect(&task_, &BackgroundTask::finished, this, &StimulusExaminer::begin_next);
}

void StimulusExaminer::request(const QObject* page,
                               std::vector<std::shared_ptr<const Protocol>> protocols, Done done) {
  connect(page, &QObject::destroyed, this, &StimulusExaminer::withdraw, Qt::UniqueConnection);
  std::erase_if(waiting_, [page](const Request& one) { return one.page == page; });
  if (current_ && current_->page == page) {
    const auto same = std::find_if(protocols.begin(), protocols.end(), [this](const auto& one) {
      return one->source == current_->protocol->source;
    });
    if (same == protocols.end()) {
      stop();
    } else {
      current_->done = done;
      protocols.erase(same);
    }
  }
  for (auto& protocol : protocols) waiting_.push_back({page, std::move(protocol), done});
  begin_next();
}

void StimulusExaminer::withdraw(const QObject* page) {
  std::erase_if(waiting_, [page](const Request& one) { return one.page == page; });
  if (current_ && current_->page == page) stop();
}

StimulusExaminer::Hold StimulusExaminer::hold() {
  if (Hold other = hold_.lock()) return other;
  Hold made(this, [self = QPointer<StimulusExaminer>(this)](const void*) {
    if (self) self->end_hold();
  });
  hold_ = made;
  if (current_) {
    waiting_.push_front(*current_);
    stop();
  }
  emit held_changed();
  return made;
}

void StimulusExaminer::end_hold() {
  begin_next();
  emit held_changed();
}

/// On the worker.
StimulusExaminer::Found StimulusExaminer::found_in(const Protocol& protocol,
                                                   const std::filesystem::path& study,
                                                   const Known& known, const Examine& examine,
                                                   const std::stop_token& stop) {
  Found found{.key = content_key(protocol, study)};
  if (const auto before = known.find(found.key); before != known.end()) {
    found.result = before->second;
    return found;
  }
  found.result = std::make_shared<const StimulusExamination>(examine(protocol, stop));
  if (!stop.stop_requested()) found.is_outdated = content_key(protocol, study) != found.key;
  return found;
}

void StimulusExaminer::begin_next() {
  if (is_held() || task_.is_running() || waiting_.empty()) return;
  current_ = std::move(waiting_.front());
  waiting_.pop_front();
  task_.run<Found>(
      [protocol = current_->protocol, study = study_, known = known_, examine = examine_](
          const std::stop_token& stop, const BackgroundTask::Progress&) {
        return found_in(*protocol, study, known, examine, stop);
      },
      [this](const Found& found) { deliver(found); },
      [this](const QString& what) {
        const Diagnostic warning{.message =
                                     phrase("Protocols", "the stimuli could not be examined: %1")
                                         .with(what.toStdString())};
        deliver({.result = std::make_shared<const StimulusExamination>(
                     StimulusExamination{.warnings = {warning}})});
      });
}

/// The worker ends at its next stimulus; then the next request is begun.
void StimulusExaminer::stop() {
  current_.reset();
  task_.cancel();
}

void StimulusExaminer::deliver(const Found& found) {
  if (!current_) return;  // it was stopped: the result is incomplete
  const Request request = std::move(*current_);
  current_.reset();
  if (found.is_outdated) {
    waiting_.push_front(request);
    return;
  }
  if (!found.key.empty()) known_.insert_or_assign(found.key, found.result);
  request.done(*request.protocol, found.result);
}

}  // namespace asperity

#include "moc_stimulus_examiner.cpp"
