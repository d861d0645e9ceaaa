// The list of pages at the left of the study window.

#pragma once

#include <QtWidgets/QListWidget>

namespace asperity {

/// Names of pages, each with a few words about what is in it at the right: "12", "1 ready".
class NavigationList final : public QListWidget {
  Q_OBJECT
 public:
  explicit NavigationList(QWidget* parent = nullptr);

  void add_page(const QString& key, const QString& name);
  void set_count(const QString& key, const QString& count);
  /// Nothing when there is no such page.
  void select(const QString& key);
  QString selected() const;

 signals:
  void page_selected(const QString& key);

 private:
  QListWidgetItem* item_of(const QString& key) const;
  void make_room();
};

}  // namespace asperity
