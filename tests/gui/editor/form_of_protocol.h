// A form with the text of a protocol, and the steps of a person who uses it.

#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <QtTest/QTest>
#include <QtWidgets/QApplication>
#include <QtWidgets/QComboBox>
#include <QtWidgets/QLineEdit>
#include <QtWidgets/QToolButton>
#include <nlohmann/json.hpp>

#include "app/gui/editor/form/protocol_form.h"
#include "app/gui/editor/protocol_text_edit.h"
#include "app/gui/editor/protocol_views.h"
#include "renderers/built_in_models.h"
#include "tests/gui/study/quiet_home.h"

namespace asperity {

class FormOfProtocol : public QuietHome {
 protected:
  FormOfProtocol() : views_(declarations_of(built_in_models())) {
    views_.resize(900, 700);
    views_.show();
  }

  void open(const std::string& text) {
    views_.text().setPlainText(QString::fromStdString(text));
    views_.show_form_if_possible();
  }
  ProtocolForm& form() { return child<ProtocolForm>(views_, "editor_form"); }
  std::string text() { return views_.text().text().toStdString(); }
  nlohmann::json tree() { return nlohmann::json::parse(text()); }
  void undo() { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Z, Qt::ControlModifier); }

  /// The controls with the frame of what is found.
  std::vector<QWidget*> marked() {
    std::vector<QWidget*> all{};
    for (QWidget* const widget : form().findChildren<QWidget*>()) {
      if (widget->property("marked").toBool()) all.push_back(widget);
    }
    return all;
  }

  /// The part of the form for the value, unfolded; null if there is none.
  FormPart* part(const std::string& pointer) {
    form().go_to(pointer);
    QApplication::processEvents();
    for (FormPart* const part : form().findChildren<FormPart*>(QString::fromStdString(pointer))) {
      if (part->isVisible()) return part;
    }
    ADD_FAILURE() << "no part for " << pointer;
    return nullptr;
  }
  template <class Control>
  Control& control(const std::string& pointer) {
    auto* const found = qobject_cast<Control*>(part(pointer)->focusProxy());
    if (found == nullptr) throw std::runtime_error("another control at " + pointer);
    return *found;
  }
  void type_into(const std::string& pointer, const QString& typed) {
    auto& line = control<QLineEdit>(pointer);
    line.setFocus();
    line.selectAll();
    QTest::keyClicks(&line, typed);
  }
  void click(const std::string& name) {
    for (QAbstractButton* const button :
         form().findChildren<QAbstractButton*>(QString::fromStdString(name))) {
      if (!button->isVisible()) continue;
      button->click();
      QApplication::processEvents();
      return;
    }
    ADD_FAILURE() << "no button " << name;
  }
  /// The button of an entry's card or line with this accessible name.
  void click_named(const QString& name) {
    for (QToolButton* const button : form().findChildren<QToolButton*>()) {
      if (!button->isVisible() || button->accessibleName() != name) continue;
      button->click();
      QApplication::processEvents();
      return;
    }
    ADD_FAILURE() << "no button " << name.toStdString();
  }
  void choose(const std::string& pointer, const QString& value) {
    auto& box = control<QComboBox>(pointer);
    const int index = box.findData(value);
    ASSERT_GE(index, 0) << value.toStdString();
    box.setCurrentIndex(index);
    emit box.activated(index);
  }
  /// Shows a page with everything in it.
  void unfold(const FormPage& page) {
    form().show_page(page.id);
    for (bool has_more = true; has_more;) {
      has_more = false;
      QApplication::processEvents();  // shows what was made
      QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      for (QToolButton* const fold : form().findChildren<QToolButton*>()) {
        if (!fold->isVisible() || !fold->objectName().startsWith("open:")) continue;
        if (fold->arrowType() != Qt::RightArrow) continue;
        fold->click();
        has_more = true;
        break;
      }
    }
  }

  ProtocolViews views_;
};

}  // namespace asperity
