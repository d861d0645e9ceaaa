// Polls for typed lines, so that faults and pauses end a wait, and hands each to the dialogue.

#include "app/session/respondents/terminal_respondent.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>
#include <variant>

#include <poll.h>
#include <termios.h>

#include "app/session/respondents/dialogues/answer_dialogue.h"
#include "app/session/respondents/typed_answer.h"
#include "app/study_files/height_field_files.h"
#include "app/words/reason.h"
#include "app/words/text_parts.h"
#include "stimuli/photographs/preview.h"

namespace asperity {

namespace {

constexpr double kTerminalPoll_s = 0.05;
constexpr const char* kAfterFault =
    "When the fault is fixed and it is safe, press Return to continue; to end the session here, "
    "type: end\n";

/// The width of the terminal, limited to a length of line that is easy to read.
std::size_t columns_of_terminal(int terminal) {
  constexpr std::size_t kUsual = 80;
  constexpr std::size_t kMost = 100;
  winsize size{};
  if (::ioctl(terminal, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return kUsual;
  return std::min<std::size_t>(size.ws_col, kMost);
}

}  // namespace

TerminalRespondent::TerminalRespondent(int input, std::ostream& output, std::filesystem::path study,
                                       std::filesystem::path sheet)
    : input_(input), output_(output), study_(std::move(study)), sheet_(std::move(sheet)) {}

void TerminalRespondent::show(const std::vector<std::string>& pictures) {
  constexpr std::size_t kRows = 400;
  if (in_grey_) {
    std::vector<GreyImage> images{};
    for (const std::string& picture : pictures) {
      images.push_back(load_photograph(study_ / picture).photograph.grey);
    }
    return save_picture(sheet_, side_by_side(images, kRows), Overwrite::allow);
  }
  // Each colour channel is laid out as a separate picture.
  std::array<std::vector<GreyImage>, 3> planes{};
  for (const std::string& picture : pictures) {
    ColorPlanes colours = load_color_picture(study_ / picture);
    for (std::size_t i = 0; i < planes.size(); ++i) planes[i].push_back(std::move(colours[i]));
  }
  ColorPlanes sheet{};
  for (std::size_t i = 0; i < planes.size(); ++i) sheet[i] = side_by_side(planes[i], kRows);
  save_color_picture(sheet_, sheet, Overwrite::allow);
}

std::optional<std::string> TerminalRespondent::typed_line() {
  for (;;) {
    if (const auto end = buffer_.find('\n'); end != std::string::npos) {
      std::string text = trimmed(buffer_.substr(0, end));
      buffer_.erase(0, end + 1);
      return text;
    }
    pollfd ready{input_, POLLIN, 0};
    if (::poll(&ready, 1, 0) <= 0) return {};
    std::array<char, 512> bytes{};
    const ssize_t count = ::read(input_, bytes.data(), bytes.size());
    if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) {
      throw RespondentGone(phrase_of(Reason::terminal_closed));
    }
    if (count > 0) buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

std::optional<std::string> TerminalRespondent::line(const Wait& wait,
                                                    const std::optional<double>& left_s) {
  unechoed_.reset();
  for (;;) {
    const bool is_late = left_s && *left_s <= 0.0;
    if (is_late && buffer_.find('\n') == std::string::npos) return {};
    if (std::optional<std::string> text = typed_line()) return text;
    wait(kTerminalPoll_s);
  }
}

void TerminalRespondent::hear_of_fault(const std::string& what) {
  unechoed_.reset();
  forget_typed();  // text typed earlier does not answer this
  output_ << "\n\n" << what << '\n' << kAfterFault << std::flush;
}

Respondent::AfterFault TerminalRespondent::after_fault() {
  const std::optional<std::string> typed = typed_line();
  if (!typed) return AfterFault::nothing;
  if (typed->empty()) return AfterFault::go_on;
  if (*typed == "end") return AfterFault::end;
  output_ << kAfterFault << std::flush;
  return AfterFault::nothing;
}

void TerminalRespondent::forget_typed() {
  ::tcflush(input_, TCIFLUSH);
  buffer_.clear();
}

void TerminalRespondent::read(const std::string& text, double minimum_s, const Wait& wait) {
  output_ << '\n' << wrapped_text(text, columns_of_terminal(input_)) << '\n';
  if (minimum_s > 0.0) {
    output_ << "(at least " << static_cast<int>(minimum_s) << " s)\n" << std::flush;
    wait(minimum_s);
    // A Return during the break ends neither the break nor what follows.
    while (typed_line()) {
    }
    forget_typed();
  }
  output_ << "Press Return to continue. " << std::flush;
  line(wait);
}

void TerminalRespondent::announce(const Trial& trial, const PlannedPresentation& surface) {
  if (surface.position == 1 && trial.standard_picture) {
    show({*trial.standard_picture});
    output_ << "\nThe picture is in " << sheet_.string() << ".\n";
  }
  visits_.add(surface.position);
  const bool all = trial.arrangement.surfaces == Arrangement::Surfaces::side_by_side;
  felt_side_by_side_ = all;
  const ParticipantScene scene =
      all ? scene_of_patches(trial) : scene_of_surface(trial, {}, surface.position);
  output_ << '\n' << scene.text << std::endl;
  if (!unechoed_) unechoed_.emplace(input_);
}

Reply TerminalRespondent::ask(const Trial& trial, std::span<const Question> page,
                              std::span<const ForceFeatures>, std::optional<double> deadline_s,
                              const Wait& wait) {
  // Text typed while the surfaces were felt does not answer the question; text typed after the
  // question is shown does, also while its pictures are read.
  unechoed_.reset();
  forget_typed();
  // One deadline for the whole page, regardless of the number of lines.
  std::optional<double> left_s = deadline_s;
  const Wait timed = [&](double duration_s) {
    wait(duration_s);
    if (left_s) left_s = std::max(0.0, *left_s - duration_s);
  };
  GivenAnswers given{};
  for (const Question& question : page) {
    Heard heard = ask(trial, question, left_s, timed);
    if (std::holds_alternative<NoAnswer>(heard)) return {};
    if (const auto* const again = std::get_if<FeelAgain>(&heard)) {
      if (!given.empty())
        output_ << "After that, please answer all questions on this page again.\n";
      return {*again};
    }
    given.push_back({std::get<std::optional<Answer>>(std::move(heard)).value(), {}});
  }
  return {std::move(given)};
}

void TerminalRespondent::put(const Question& question) {
  output_ << '\n'
          << wrapped_text(question.prompt + (question.optional ? " (may be left empty)" : ""),
                          columns_of_terminal(input_))
          << '\n';
  std::vector<std::string> pictures{};
  for (std::size_t i = 0; i < question.options.size(); ++i) {
    const Option& option = question.options[i];
    if (option.picture) pictures.push_back(*option.picture);
    output_ << "  " << i + 1 << "  " << (option.picture ? "picture " : "")
            << (option.text.empty() ? option.label : option.text) << '\n';
  }
  if (pictures.empty()) return;
  output_ << std::flush;
  show(pictures);
  output_ << "The pictures are in " << sheet_.string() << ", numbered 1 to " << pictures.size()
          << " from left to right.\n";
}

TerminalRespondent::Heard TerminalRespondent::ask(const Trial& trial, const Question& question,
                                                  const std::optional<double>& left_s,
                                                  const Wait& timed) {
  put(question);
  if (visits_.owed(trial)) {
    output_ << "To feel a surface, type feel and its letter, for example: feel A\n";
  } else if (trial.arrangement.allows_revisits() && visits_.next(trial, 0)) {
    output_ << "To feel a surface again, type feel and its letter, for example: feel A\n";
  }
  return hear(*dialogue_for(question, trial.presentations), &trial, left_s, timed);
}

TerminalRespondent::Heard TerminalRespondent::hear(AnswerDialogue& dialogue, const Trial* trial,
                                                   const std::optional<double>& left_s,
                                                   const Wait& timed) {
  output_ << dialogue.introduction();
  for (;;) {
    output_ << dialogue.prompt() << std::flush;
    const std::optional<std::string> typed = line(timed, left_s);
    if (!typed) return NoAnswer{};
    bool is_wish = false;
    if (const std::optional<int> again = trial ? wish_in(*typed, *trial, is_wish) : std::nullopt) {
      const std::string note = dialogue.note_on_discarding();
      if (!note.empty()) output_ << note << '\n';
      return FeelAgain{*again};
    }
    if (is_wish) continue;
    if (const std::optional<int> owed = trial ? visits_.owed(*trial) : std::nullopt) {
      const PlannedPresentation& first =
          trial->presentations.at(static_cast<std::size_t>(*owed - 1));
      output_ << text_of({.what = ParticipantMessage::What::feel_first, .code = first.code})
              << '\n';
      continue;
    }
    std::variant<NextLine, std::optional<Answer>> taken = dialogue.take(*typed);
    if (auto* const answer = std::get_if<std::optional<Answer>>(&taken)) return std::move(*answer);
    const std::string& complaint = std::get<NextLine>(taken).complaint;
    if (!complaint.empty()) output_ << complaint << '\n';
  }
}

std::optional<int> TerminalRespondent::wish_in(const std::string& typed, const Trial& trial,
                                               bool& said) {
  // An answer in words may begin with the same word.
  const std::string rest = typed.rfind("feel ", 0) == 0 ? trimmed(typed.substr(5)) : std::string();
  said = trial.arrangement.allows_revisits() && rest.size() == 1;
  if (!said) return {};
  std::string code = rest;
  for (char& letter : code) {
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  }
  std::string codes{};
  for (const PlannedPresentation& surface : trial.presentations) {
    if (surface.code == code && !visits_.may_visit(trial, surface.position)) {
      output_ << text_of({.what = ParticipantMessage::What::felt_often_enough, .code = code})
              << '\n';
      return {};
    }
    if (surface.code == code) return surface.position;
    codes += (codes.empty() ? "" : ", ") + surface.code;
  }
  output_ << "There is no surface " << code
          << ". Please type feel and one of these letters: " << codes << ".\n";
  return {};
}

void TerminalRespondent::tell(const std::string& text, const Wait&) {
  output_ << text << std::endl;
}

std::optional<Answer> TerminalRespondent::answer(const Question& question, const Wait& wait) {
  put(question);
  return std::get<std::optional<Answer>>(hear(*dialogue_for(question), nullptr, {}, wait));
}

}  // namespace asperity
