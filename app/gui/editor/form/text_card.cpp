// Implements the card for a value that a form does not show.

#include "app/gui/editor/form/text_card.h"

#include <nlohmann/json.hpp>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"
#include "app/gui/look/wrapping_row.h"

namespace asperity {

TextCard::TextCard(FormContext& context, const std::string& pointer, QWidget* parent)
    : FormPart(context, pointer, parent) {
  auto* layout = new WrappingRow(this);
  words_ = make_text({}, this, true);
  QPushButton* show = make_button(tr("Show in the text"), ButtonRole::link, this);
  layout->addWidget(words_);
  layout->addWidget(show);
  connect(show, &QPushButton::clicked, this,
          [this] { this->context().show_in_text(this->pointer()); });
}

void TextCard::refresh() {
  const std::string key = nlohmann::json::json_pointer(pointer()).back();
  words_->setText(tr("%1: defined in the text").arg(text(key)));
}

}  // namespace asperity

#include "moc_text_card.cpp"
