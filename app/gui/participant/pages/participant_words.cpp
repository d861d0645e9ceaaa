// Looks up the phrase of a message in the language of the protocol; a text of the protocol stays as written.

#include "app/gui/participant/pages/participant_words.h"

#include "app/gui/look/words.h"
#include "app/words/phrase_of_error.h"

namespace asperity {

QString words_of(const ParticipantMessage& message, const std::string& text,
                 const std::string& language) {
  return message.what == ParticipantMessage::What::nothing
             ? QString::fromStdString(text)
             : words_in_language(language, phrase_of(message));
}

}  // namespace asperity
