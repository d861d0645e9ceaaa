// A view of a participant on a monitor that the test fills, and what was done to it.

#pragma once

#include <memory>
#include <vector>

#include <QtTest/QTest>
#include <gtest/gtest.h>

#include "app/gui/participant/participant_view.h"
#include "app/gui/participant/response_keys.h"
#include "tests/gui/participant/scenes.h"
#include "tests/gui/support/widgets.h"

namespace asperity {

struct Seat {
  using Item = ParticipantItem;

  scenes::PictureFolder pictures{};
  SessionMonitor monitor{};
  ParticipantView view{monitor, pictures.path(), ParticipantView::Role::participant};
  ResponseKeys keys{view};
  std::vector<ParticipantInput> inputs{};

  Seat() {
    QObject::connect(&view, &ParticipantView::acted, [this](const ParticipantInput& input) {
      if (input.kind != ParticipantInput::Kind::released) inputs.push_back(input);
    });
    view.resize(1366, 768);
    view.show();
  }
  explicit Seat(const ParticipantScene& scene) : Seat() { show(scene); }
  void show(const ParticipantScene& scene) {
    monitor.show(scene);
    const std::shared_ptr<const ParticipantScene> shown = monitor.snapshot().scene;
    ASSERT_TRUE(eventually([&] { return &view.scene() == shown.get(); }));
  }
  QPoint place_of(Item::Kind kind, const QString& text_or_key) const {
    for (const Item& item : view.items()) {
      if (item.kind == kind && (item.text == text_or_key || item.key == text_or_key)) {
        return item.rect.center().toPoint();
      }
    }
    ADD_FAILURE() << "nothing says " << text_or_key.toStdString();
    return {};
  }
  void click(Item::Kind kind, const QString& text_or_key) {
    QTest::mouseClick(&view, Qt::LeftButton, {}, place_of(kind, text_or_key));
  }
  void key(Qt::Key key) { QTest::keyClick(&view, key); }
  ParticipantInput last() const { return inputs.empty() ? ParticipantInput{} : inputs.back(); }
};

}  // namespace asperity
