// The interface of a page of the participant's window: its layout, drawing, keys and pointer.

#pragma once

#include <optional>

#include <QtCore/QPointF>
#include <QtCore/QString>

#include "app/gui/participant/pages/participant_item.h"
#include "app/session/respondents/participant_input.h"

namespace asperity {

class PageFrame;
class ParticipantBrush;

/// The effect of an action on a page.
struct ActionEffect {
  /// An input for the session; the caller sets its time and source.
  std::optional<ParticipantInput> told{};
  bool shows_answer = false;  ///< the page of the picture that has the answer is shown
};

/// The page of one kind of scene, or of one form of answer, in a trial and in the questionnaire. To add a form: its file,
/// and its line in page_for.cpp.
///
/// A page has no state and no rules of responding: the draft stores what is not confirmed yet, and
/// the session refuses what is not permitted.
class ParticipantPage {
 public:
  virtual ~ParticipantPage() = default;
  ParticipantPage(const ParticipantPage&) = delete;
  ParticipantPage& operator=(const ParticipantPage&) = delete;

  // --- layout and drawing ---
  /// Fills the body of the frame.
  virtual void lay_out(PageFrame& frame) const = 0;
  /// The controls of the last page of the picture, without those that turn pages; outermost first.
  virtual void add_controls(PageFrame& frame) const = 0;
  /// Draws an item; the default draws those that several pages have.
  virtual void draw(ParticipantBrush& brush, const ParticipantItem& item) const;

  // --- keys ---
  /// The meaning of a key; `typed` is its text in capitals. Nothing where the scene does not use it.
  virtual std::optional<ParticipantAction> action_of_key(const ParticipantScene& scene, int key,
                                                         const QString& typed) const = 0;
  /// The second digit of a key of two ("12") corrects the choice that the first one made.
  virtual bool takes_two_digits() const { return true; }
  enum class Typing { none, number, text };
  virtual Typing typing(const ParticipantScene&) const { return Typing::none; }
  /// Keys may be private: only the answer is stored.
  virtual bool is_private() const { return false; }
  /// Nothing is answered yet: a confirmation would leave an optional question empty.
  virtual bool is_empty(const ParticipantScene& scene, const ParticipantDraft& draft) const;
  /// The effect of an action, by key or by pointer.
  virtual ActionEffect act(const ParticipantScene& scene, const ParticipantAction& action,
                           ParticipantDraft& draft) const;

  // --- the pointer ---
  /// Where a pointer that holds `item` and is at `at` sets a mark, from the press on, as
  /// ParticipantAction::position; nothing for an item that acts when the pointer is released.
  virtual std::optional<double> position_at(const ParticipantItem& /*item*/, QPointF /*at*/) const {
    return {};
  }
  /// The letter of the surface that a drag from `item` carries; empty: none.
  virtual QString carried_from(const ParticipantItem&) const { return {}; }
  /// The input of a drag that ends over `onto`, which is null where nothing can be pressed.
  virtual std::optional<ParticipantInput> dropped(const ParticipantScene&,
                                                  const ParticipantItem& /*from*/,
                                                  const ParticipantItem* /*onto*/) const {
    return {};
  }

 protected:
  ParticipantPage() = default;
};

}  // namespace asperity
