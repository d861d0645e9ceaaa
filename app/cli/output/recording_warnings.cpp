// Prints the first sentences about a recording, and the number of the others.

#include "app/cli/output/recording_warnings.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "analysis/numbers/number_text.h"
#include "app/cli/output/terminal.h"

namespace asperity {

void warn_of_uneven_strokes(const TextureRecording& recording, const std::string& name) {
  constexpr std::size_t kMostPrinted = 3;
  const std::vector<std::string> sentences = uneven_strokes(recording);
  for (std::size_t i = 0; i < std::min(sentences.size(), kMostPrinted); ++i) {
    say("asperity: warning: " + name + ": " + sentences[i]);
  }
  if (sentences.size() > kMostPrinted) {
    say("asperity: warning: " + name + ": " +
        counted(sentences.size() - kMostPrinted, "further warning") + " of this kind");
  }
}

}  // namespace asperity
