// Declares the fields of a form in which something is chosen.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/gui/editor/form/form_fields.h"

class QCheckBox;
class QVBoxLayout;

namespace asperity {

class ChoiceBox;

/// true or false.
class TruthField final : public FormPart {
  Q_OBJECT
 public:
  TruthField(FormContext& context, const FieldOf& of, const std::string& pointer, QWidget* parent);
  void refresh() override;

 private:
  FieldOf of_{};
  QCheckBox* box_ = nullptr;
};

/// One of several texts: a word, a name that is declared elsewhere, a choice of a force model.
class ChoiceField final : public FormPart {
  Q_OBJECT
 public:
  struct Choice {
    std::string value{};
    QString text{};
    QString shown_value{};  ///< the text without its explanation; empty: it has none
  };
  using Choices = std::function<std::vector<Choice>()>;

  ChoiceField(FormContext& context, Choices choices, const FieldOf& of, const std::string& pointer,
              QWidget* parent);
  void refresh() override;
  /// Adds a button that makes what can be chosen.
  void offer(const QString& text, std::function<void()> make);

 private:
  void take(int index);

  Choices choices_{};
  FieldOf of_{};
  ChoiceBox* box_ = nullptr;
};

/// A value that is the same in all trials, or the level of a factor.
class BoundField final : public FormPart {
  Q_OBJECT
 public:
  BoundField(FormContext& context, const ValueShape& shape, const FieldOf& of,
             const std::string& pointer, QWidget* parent);
  void refresh() override;
  void set_name(const QString& name) override;

 private:
  void take(int index);

  ValueShape shape_{};
  FieldOf of_{};
  ChoiceBox* source_ = nullptr;
  FormPart* fixed_ = nullptr;
};

}  // namespace asperity
