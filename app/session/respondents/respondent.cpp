// Implements the default for the eye mask: a text that is read.

#include "app/session/respondents/respondent.h"

namespace asperity {

void Respondent::put_mask(bool on, const Wait& wait) {
  read(on ? "Please put on the eye mask." : "Please take off the eye mask.", 0.0, wait);
}

}  // namespace asperity
