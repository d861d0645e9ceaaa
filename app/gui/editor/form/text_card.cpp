// Implements the card for a value that a form does not show.

#include "app/gui/editor/form/text_card.h"

#include <QtWidgets/QHBoxLayout>
#include <nlohmann/json.hpp>

#include "app/gui/look/controls.h"
#include "app/gui/look/words.h"

namespace asperity {

TextCard::TextCard(FormContext& context, const std::string& pointer, QWidget* parent)
    : FormPart(context, pointer, parent) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  words_ = make_text({}, this, true);
  words_->setWordWrap(false);
  QPushButton* show = make_button(tr("Show in the text"), ButtonRole::link, this);
  layout->addWidget(words_);
  layout->addWidget(show);
  layout->addStretch();
  connect(show, &QPushButton::clicked, this,
          [this] { this->context().show_in_text(this->pointer()); });
}

void TextCard::refresh() {
  const std::string key = nlohmann::json::json_pointer(pointer()).back();
  words_->setText(
      tr("%1: defined in the text (line %2)").arg(text(key)).arg(source().line_of(pointer())));
}

}  // namespace asperity

#include "moc_text_card.cpp"
