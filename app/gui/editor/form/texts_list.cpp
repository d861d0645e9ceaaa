// Implements the list of all texts that participants read.

#include "app/gui/editor/form/texts_list.h"

#include <QtWidgets/QVBoxLayout>

#include "app/gui/base/form_words.h"
#include "app/gui/editor/form/form_fields.h"
#include "app/gui/look/controls.h"
#include "protocols/texts/translatable_texts.h"

namespace asperity {

TextsList::TextsList(FormContext& context, QWidget* parent) : FormPart(context, "/", parent) {
  layout_ = new QVBoxLayout(this);
  layout_->setContentsMargins(0, 0, 0, 0);
}

void TextsList::refresh() {
  std::vector<TranslatableText> texts = translatable_texts(source().document().root());
  std::erase_if(texts, [](const TranslatableText& text) {
    return text.shape.translated != Translated::always;
  });
  std::vector<std::string> pointers{};
  for (const TranslatableText& text : texts) pointers.push_back(text.pointer);
  if (pointers != made_) {
    clear_layout(*layout_);
    fields_.clear();
    for (const TranslatableText& one : texts) {
      const QString place = path_in_form(source().document().root(), one.pointer);
      layout_->addWidget(make_text(place, this, true));
      FormPart* field = make_field(context(), one.shape, {}, one.pointer, this);
      field->set_name(place);
      layout_->addWidget(field);
      fields_.push_back(field);
    }
    made_ = std::move(pointers);
  }
  for (FormPart* const field : fields_) field->refresh();
}

}  // namespace asperity

#include "moc_texts_list.cpp"
