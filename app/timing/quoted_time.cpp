// Holds the table of quoted times by scene, each with its source.

#include "app/timing/quoted_time.h"

#include <array>

namespace asperity {

namespace {

constexpr std::string_view kSimple =
    "[Otaduy 2004], simple benchmarks; two Pentium 4 at 2.4 GHz, GeForce FX 5950";
constexpr std::string_view kComplex =
    "[Otaduy 2004], complex benchmarks, worst case (course slides: 0.1 to 0.2 kHz); the same "
    "computer";
constexpr std::string_view kTexturedPlane =
    "CHAI3D 3.3.0 (commit 7c76b1f2), a textured plane with friction; docs/performance.md, \"A "
    "point on a "
    "body\"";
constexpr std::string_view kBumpyMesh =
    "CHAI3D 3.3.0 (commit 7c76b1f2), a bumpy mesh of the same size; docs/performance.md, \"A point "
    "on a "
    "body\"";

struct Quotation {
  std::string_view scene{};
  QuotedTime time{};
};

constexpr std::array kQuotations{
    Quotation{"simple", {"0.5 kHz", kSimple}},
    Quotation{"hammer", {"0.1 to 0.4 kHz", kComplex}},
    Quotation{"file", {"0.1 to 0.4 kHz", kComplex}},
    Quotation{"part", {"0.1 to 0.4 kHz", kComplex}},
    Quotation{"plane", {"p50 0.76 µs, p99 0.91 µs", kTexturedPlane}},
    Quotation{"mesh_100k", {"265 µs, 51 N in place of 1 N", kBumpyMesh}},
    Quotation{"mesh_600k", {"1375 µs, 67 N in place of 1 N", kBumpyMesh}}};

}  // namespace

std::optional<QuotedTime> quoted_time(std::string_view scene) noexcept {
  for (const Quotation& each : kQuotations) {
    if (each.scene == scene) return each.time;
  }
  return std::nullopt;
}

}  // namespace asperity
