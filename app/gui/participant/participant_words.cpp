#include "app/gui/participant/participant_words.h"

#include "app/gui/look/words.h"

namespace asperity {

QString words_of(const Saying& saying, const std::string& text) {
  return saying.what == Saying::What::nothing ? QString::fromStdString(text)
                                              : words_of(phrase_of(saying));
}

}  // namespace asperity
