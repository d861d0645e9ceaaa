// Declares the fields of a form in which something is typed.

#pragma once

#include <functional>
#include <string>

#include "app/gui/editor/form/form_fields.h"

class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace asperity {

/// A line of typed characters.
class LineField : public FormPart {
  Q_OBJECT
 public:
  LineField(FormContext& context, const FieldOf& of, const std::string& pointer, QWidget* parent);
  void refresh() override;

 protected:
  /// How a value is shown: characters of the file, empty if there is none.
  virtual QString shown(std::string_view characters) const = 0;
  /// The value as JSON.
  virtual std::string json_of(const QString& typed) const = 0;
  void set_unit(const QString& unit);
  QLineEdit& line() const noexcept { return *line_; }

 private:
  void take(const QString& typed);

  FieldOf of_{};
  QLineEdit* line_ = nullptr;
  QLabel* unit_ = nullptr;
  std::string taken_{};  ///< the characters of the value when something was typed last
};

/// One number, or several with semicolons between them, in the unit for display; also text in place of a number, which
/// the check of the protocol reports.
class NumbersField final : public LineField {
  Q_OBJECT
 public:
  enum class Count { one, list };
  NumbersField(FormContext& context, const NumberShape& shape, Count count, const FieldOf& of,
               const std::string& pointer, QWidget* parent);

 private:
  QString shown(std::string_view characters) const override;
  std::string json_of(const QString& typed) const override;

  NumberShape shape_{};
  Count count_ = Count::one;
};

/// A text of one line; or a level, which is a number if it is written as one.
class TextField final : public LineField {
  Q_OBJECT
 public:
  enum class Values { texts, levels };
  TextField(FormContext& context, const NameShape& offered, Values values, const FieldOf& of,
            const std::string& pointer, QWidget* parent);
  /// Those that contain what is typed, and all with the down arrow key.
  void offer(std::function<QStringList()> texts);

 private:
  QString shown(std::string_view characters) const override;
  std::string json_of(const QString& typed) const override;

  Values values_ = Values::texts;
};

/// A text of several lines, in a box that grows with it.
class ParagraphField final : public FormPart {
  Q_OBJECT
 public:
  ParagraphField(FormContext& context, const FieldOf& of, const std::string& pointer,
                 QWidget* parent);
  void refresh() override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void take();
  void fit();

  FieldOf of_{};
  QPlainTextEdit* box_ = nullptr;
};

/// A name that is declared here: a new one is written to all places that refer to it, when it is complete. A level can
/// become a number, and a level that is a texture another texture.
class DeclaredNameField final : public FormPart {
  Q_OBJECT
 public:
  /// Of the value at `pointer`, or of the key of the member.
  DeclaredNameField(FormContext& context, Named named, TextField::Values values, const FieldOf& of,
                    const std::string& pointer, QWidget* parent);
  ~DeclaredNameField() override;
  void refresh() override;

 private:
  QString name() const;
  FormEdit renamed(const JsonDocument& document, const QString& typed) const;
  void wait_for_the_rest();
  void take();

  Named named_ = Named::by_value;
  TextField::Values values_ = TextField::Values::texts;
  FieldOf of_{};
  QLineEdit* line_ = nullptr;
  QLabel* refusal_ = nullptr;  ///< why the name that was typed last cannot be written
  std::shared_ptr<const FormSource> refused_in_{};  ///< null: the last one was written
  bool is_typed_ = false;                           ///< and not written yet
};

}  // namespace asperity
