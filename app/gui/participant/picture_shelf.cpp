// Decodes and scales the requested squares in a background task, and keeps a limited number of sizes.

#include "app/gui/participant/picture_shelf.h"

#include <algorithm>
#include <memory>

#include <QtGui/QImageReader>

namespace asperity {

namespace {

// No picture is shown larger than about half a screen's height.
constexpr int kLargest_px = 1200;
// A window that is being resized asks for every size on its way.
constexpr std::size_t kKept = 96;

QImage square_of(const QString& file, bool in_grey) {
  QImageReader reader(file);
  reader.setAutoTransform(true);
  const QImage whole = reader.read();
  if (whole.isNull()) return {};
  const int side = std::min(whole.width(), whole.height());
  QImage square = whole.copy((whole.width() - side) / 2, (whole.height() - side) / 2, side, side)
                      .convertToFormat(in_grey ? QImage::Format_Grayscale8 : QImage::Format_RGB32)
                      .convertToFormat(QImage::Format_RGB32);
  if (side > kLargest_px) {
    square =
        square.scaled(kLargest_px, kLargest_px, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  }
  return square;
}

struct Fetched {
  std::map<QString, QImage> squares{};
  std::map<std::pair<QString, int>, QImage> scaled{};
  std::vector<QString> unreadable{};
};

}  // namespace

PictureShelf::PictureShelf(std::filesystem::path study, QObject* parent)
    : QObject(parent), study_(std::move(study)) {}

void PictureShelf::show_in_grey() {
  in_grey_ = true;
  task_.abandon();
  squares_.clear();
  scaled_.clear();
  fetch();
}

QPixmap PictureShelf::picture(const QString& name, int side) {
  const auto found = scaled_.find({name, side});
  if (found != scaled_.end()) return found->second;
  prepare({name}, side);
  return {};
}

bool PictureShelf::is_settled(const QString& name, int side) const {
  return unreadable_.count(name) > 0 || scaled_.count({name, side}) > 0;
}

void PictureShelf::prepare(const std::vector<QString>& names, int side) {
  for (const QString& name : names) {
    const Wanted wanted(name, side);
    if (scaled_.count(wanted) == 0 && unreadable_.count(name) == 0) wanted_.insert(wanted);
  }
  fetch();
}

void PictureShelf::fetch() {
  if (wanted_.empty() || task_.is_running()) return;
  // Images are shared, not copied: the worker reads, nobody writes.
  task_.run<Fetched>(
      [study = study_, squares = squares_, wanted = wanted_, in_grey = in_grey_](
          const std::stop_token& stop, const BackgroundTask::Progress&) {
        Fetched fetched{};
        for (const auto& [name, side] : wanted) {
          if (stop.stop_requested()) break;
          QImage square{};
          if (const auto known = squares.find(name); known != squares.end()) {
            square = known->second;
          } else if (const auto read = fetched.squares.find(name); read != fetched.squares.end()) {
            square = read->second;
          } else {
            square =
                square_of(QString::fromStdString((study / name.toStdString()).string()), in_grey);
            if (square.isNull()) {
              fetched.unreadable.push_back(name);
              continue;
            }
            fetched.squares[name] = square;
          }
          fetched.scaled[{name, side}] =
              square.scaled(side, side, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        }
        return fetched;
      },
      [this](const Fetched& fetched) {
        for (const auto& [name, square] : fetched.squares) squares_[name] = square;
        if (scaled_.size() > kKept) scaled_.clear();
        for (const auto& [wanted, image] : fetched.scaled) {
          scaled_[wanted] = QPixmap::fromImage(image);
          wanted_.erase(wanted);
        }
        for (const QString& name : fetched.unreadable) {
          if (!unreadable_.insert(name).second) continue;
          for (auto each = wanted_.begin(); each != wanted_.end();) {
            each = each->first == name ? wanted_.erase(each) : std::next(each);
          }
          emit unreadable(name);
        }
        emit arrived();
        fetch();
      },
      [](const QString&) {});
}

}  // namespace asperity

#include "moc_picture_shelf.cpp"
