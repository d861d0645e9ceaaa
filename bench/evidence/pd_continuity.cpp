// How much the force of pd_gradient changes where contacts begin, end, divide and merge, and its work on closed paths.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "bench/evidence/evidence.h"
#include "bench/evidence/pd_continuity_scenes.h"
#include "renderers/pd_gradient/contact/pd_gradient.h"
#include "tests/renderers/unexplained_change.h"

namespace asperity {
namespace {

constexpr double kLeast_N = 0.1;    // relative changes of smaller forces are relative to this
constexpr double kMuch = 0.05;      // ticks with a larger relative change are counted
constexpr double kRounding = 1e-3;  // of that: the model permits exactly 5 % of 0.1 N

/// The changes of the rendered contacts, counted by their ids.
struct Events {
  int begun = 0;
  int ended = 0;
  int split = 0;     // new in the window of one that was rendered
  int joined = 0;    // no longer rendered, in the window of one that is
  int replaced = 0;  // the id continues with another force, and the previous one fades
};

bool is_rendered(const TexturedContact& contact) {
  return is_felt(contact) && !contact.is_fading && contact.share > 0.0;
}

class EventCounter final {
 public:
  explicit EventCounter(Events& events) : events_(events) {}

  void add(std::span<const TexturedContact> found) {
    std::vector<TexturedContact> now(found.begin(), found.end());
    if (!is_first_) {
      for (const TexturedContact& contact : now) count_new(contact);
      for (const TexturedContact& last : before_) count_gone(last, now);
    }
    is_first_ = false;
    before_ = std::move(now);
  }

 private:
  static bool has_rendered(const std::vector<TexturedContact>& contacts, std::uint64_t id) {
    return std::any_of(contacts.begin(), contacts.end(), [id](const TexturedContact& contact) {
      return is_rendered(contact) && contact.id == id;
    });
  }
  static bool is_part_of_any(const TexturedContact& part,
                             const std::vector<TexturedContact>& contacts) {
    return std::any_of(contacts.begin(), contacts.end(), [&](const TexturedContact& contact) {
      return is_rendered(contact) && is_part_of(part.frame, contact);
    });
  }
  void count_new(const TexturedContact& contact) {
    if (!is_rendered(contact)) return;
    if (has_rendered(before_, contact.id)) {
      // It has the share of its last tick, unless it rises instead of another one.
      events_.replaced += fell(contact) ? 1 : 0;
    } else {
      ++(is_part_of_any(contact, before_) ? events_.split : events_.begun);
    }
  }
  bool fell(const TexturedContact& contact) const {
    return std::any_of(before_.begin(), before_.end(), [&](const TexturedContact& last) {
      return is_rendered(last) && last.id == contact.id && contact.share < last.share;
    });
  }
  void count_gone(const TexturedContact& last, const std::vector<TexturedContact>& now) {
    if (!is_rendered(last) || has_rendered(now, last.id)) return;
    ++(is_part_of_any(last, now) ? events_.joined : events_.ended);
  }

  std::vector<TexturedContact> before_{};
  Events& events_;
  bool is_first_ = true;
};

/// Of all paths of a kind.
struct Changes {
  int paths = 0;
  int ticks = 0;
  Events events{};
  double unexplained_N = 0.0;
  double unexplained_part = 0.0;
  double part_of_magnitudes = 0.0;
  int much = 0;          // ticks
  double whole_N = 0.0;  // of the change in a tick
  double force_N = 0.0;
};

void add_path(const ContactPath& path, Changes& changes) {
  TexturedContacts contacts = contacts_of(path);
  for (int tick = 0; tick < path.ticks_at_rest; ++tick) contacts.find(path.pose(0), {}, kTick_s);
  UnexplainedChange unexplained;
  EventCounter counter(changes.events);
  for (int tick = 0; tick < path.ticks; ++tick) {
    const Pose pose = path.pose(tick);
    const auto found = contacts.find(pose, {}, kTick_s);
    const UnexplainedChange::Tick change = unexplained.add(found, pose);
    counter.add(found);
    const double part = change.part(kLeast_N);
    changes.unexplained_N = std::max(changes.unexplained_N, change.unexplained_N);
    changes.unexplained_part = std::max(changes.unexplained_part, part);
    changes.part_of_magnitudes =
        std::max(changes.part_of_magnitudes, change.part_of_magnitudes(kLeast_N));
    changes.much += part > (1.0 + kRounding) * kMuch ? 1 : 0;
    changes.whole_N = std::max(changes.whole_N, change.whole_N);
    changes.force_N = std::max(changes.force_N, change.current_N);
  }
  ++changes.paths;
  changes.ticks += path.ticks;
}

/// The ratio of net to gross work over all closed paths of a kind, and the limited contacts.
struct Works {
  std::vector<double> net_over_gross{};
  double net_J = 0.0;
  double gross_J = 0.0;
  double rendered = 0.0;
  double bounded = 0.0;
};

Works works_of(const std::vector<ClosedPath>& paths, int ticks) {
  Works works;
  for (const ClosedPath& path : paths) {
    const PathWork work = work_around(path, ticks);
    works.net_over_gross.push_back(work.net_J / work.gross_J);
    works.net_J += work.net_J;
    works.gross_J += work.gross_J;
    works.rendered += static_cast<double>(work.rendered);
    works.bounded += static_cast<double>(work.bounded);
  }
  return works;
}

void print_changes_header() {
  std::printf(
      "largest change of the force in a tick of 1 ms that the motion does not explain, in N and\n"
      "relative to the current force (at least %.1f N); ticks above 5 %%; relative to the sum of "
      "the\n"
      "contacts' magnitudes; largest whole change\n"
      "%-40s %5s %6s %5s %5s %5s %6s %8s %13s %7s %6s %8s %7s %7s\n",
      kLeast_N, "scene", "paths", "ticks", "begun", "ended", "split", "joined", "replaced",
      "unexplained N", "%", ">5 %", "% of sum", "whole N", "force N");
}

void print_changes(const std::vector<ContactPath>& paths) {
  Changes changes;
  for (const ContactPath& path : paths) add_path(path, changes);
  const Events& events = changes.events;
  std::printf("%-40s %5d %6d %5d %5d %5d %6d %8d %13.3f %7.1f %6d %8.1f %7.3f %7.2f\n",
              paths.front().name.c_str(), changes.paths, changes.ticks, events.begun, events.ended,
              events.split, events.joined, events.replaced, changes.unexplained_N,
              100.0 * changes.unexplained_part, changes.much, 100.0 * changes.part_of_magnitudes,
              changes.whole_N, changes.force_N);
  std::fflush(stdout);
}

void print_works_header() {
  std::printf(
      "\nwork on the hand on closed paths: of all paths, and the ratio of each path\n"
      "%-45s %5s %6s %9s %8s %8s %7s %8s %8s\n",
      "closed paths", "paths", "ticks", "limited %", "net mJ", "gross mJ", "mean %", "least %",
      "most %");
}

void print_works(const std::vector<ClosedPath>& paths, std::initializer_list<int> all_ticks) {
  for (const int ticks : all_ticks) {
    const Works works = works_of(paths, ticks);
    const auto [least, largest] =
        std::minmax_element(works.net_over_gross.begin(), works.net_over_gross.end());
    double sum = 0.0;
    for (const double one : works.net_over_gross) sum += one;
    const double mean = sum / static_cast<double>(works.net_over_gross.size());
    std::printf("%-45s %5zu %6d %9.0f %8.3f %8.3f %7.1f %8.1f %8.1f\n", paths.front().name.c_str(),
                paths.size(), ticks, 100.0 * works.bounded / std::max(1.0, works.rendered),
                1e3 * works.net_J, 1e3 * works.gross_J, 100.0 * mean, 100.0 * *least,
                100.0 * *largest);
    std::fflush(stdout);
  }
}

void print_all_changes() {
  print_changes_header();
  print_changes({ring_that_rocks()});
  print_changes({one_of_two_balls_enters()});
  print_changes({small_ball_enters_and_leaves()});
  print_changes({needle_that_is_suddenly_deep()});
  std::vector<ContactPath> walls;
  for (const double angle_degrees : {62.0, 75.0, 90.0}) {
    walls.push_back(ball_at_foot_of_wall(angle_degrees * std::numbers::pi / 180.0));
  }
  print_changes(walls);
  std::vector<ContactPath> balls;
  std::vector<ContactPath> boxes;
  for (const LowStep& step : low_steps()) {
    balls.push_back(ball_against(step));
    boxes.push_back(box_against(step));
  }
  print_changes(balls);
  print_changes(boxes);
  print_changes({comb_in_ribs()});
  constexpr std::uint64_t kThroughSheets = 24;
  balls.clear();
  boxes.clear();
  for (std::uint64_t i = 0; i < kThroughSheets; ++i) {
    const bool is_ball = i % 3 == 2;
    (is_ball ? balls : boxes).push_back(through_sheets(i, is_ball));
  }
  print_changes(boxes);
  print_changes(balls);
}

void print_all_works() {
  print_works_header();
  print_works({ring_that_is_pressed()}, {400, 1600});
  print_works({ball_through_thin_plate()}, {400, 1600, 6400});
  constexpr std::uint64_t kRocking = 24;
  std::vector<ClosedPath> paths;
  for (std::uint64_t i = 0; i < kRocking; ++i) paths.push_back(block_that_rocks(i));
  print_works(paths, {400, 1600, 6400});
  constexpr std::uint64_t kThroughSheets = 42;
  paths.clear();
  for (std::uint64_t i = 0; i < kThroughSheets; ++i) {
    paths.push_back(block_through_sheets_and_back(i));
  }
  print_works(paths, {400, 1600, 6400});
}

}  // namespace

void print_pd_continuity() {
  print_all_changes();
  print_all_works();
}

}  // namespace asperity
