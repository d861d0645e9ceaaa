// Asks for confirmation, lets the robotic functions of the SDK move the device, and requires that they end.

#include "device/force_dimension/find_zero.h"

#include <stdexcept>

#include "device/drivers.h"
#include "device/force_dimension/movement_ender.h"
#include "device/units_in_use.h"

namespace asperity::force_dimension {
namespace {

// Refuses a device whose regulation may still be running.
void require_let_go(const DhdFunctions& sdk, char id, const std::string& who, bool is_stopped) {
  // true keeps the force on. It cannot be sent while the regulation of the SDK runs.
  if (sdk.drdStop(!is_stopped, id) >= 0) return;
  const std::string words = last_error_of(sdk);
  // drdStop also fails if the MovementEnder has already ended the regulation.
  if (sdk.drdIsRunning != nullptr && !sdk.drdIsRunning(id)) return;
  if (is_stopped && sdk.drdIsRunning == nullptr) {
    throw std::runtime_error(
        who +
        " was stopped on request while it moved to find its zero, and the SDK did not confirm that "
        "it stopped (" +
        words + "). Watch the handle from a distance; if it moves, switch the device off.");
  }
  throw std::runtime_error("The SDK does not release " + who + " (" + words +
                           ") and may still move it: switch the device off.");
}

}  // namespace

void find_zero(const DhdFunctions& sdk, Identity& identity, const std::string& model,
               const std::function<bool(const std::string&)>& may_move, const std::stop_token& stop,
               const std::function<void(const std::string&)>& tell) {
  if (knows_its_zero(sdk, identity)) return;
  const std::string who = model + " " + identity.serial;
  if (!sdk.has_robotics()) {
    throw std::runtime_error(
        who +
        " is not calibrated, and libdhd alone cannot calibrate it: install libdrd of the same SDK, "
        "or calibrate the device with its manufacturer's program.");
  }
  if (!may_move) {
    throw std::runtime_error(who +
                             " has lost its zero, as happens when it is switched off, and has to "
                             "move by itself to find it. It was not moved, because the user cannot "
                             "be asked here. First run \"asperity device-test force_dimension" +
                             (identity.serial.empty() ? "" : ":" + identity.serial) +
                             sdk.library_option() +
                             "\", which requests confirmation before the device moves, or "
                             "calibrate the device as its manufacturer's manual describes.");
  }
  const auto require_no_stop = [&] {
    if (!stop.stop_requested()) return;
    throw OpeningStopped(
        who +
        " was closed and not moved: opening it was stopped on request; open it again to use it");
  };
  // Others may search for devices while the user decides.
  const UnitInUse asked_about(
      kDriver, {.model = model, .serial = identity.serial, .place = place_of(identity.index)});
  const bool is_agreed =
      may_move("the handle of " + who +
               " will move by itself, through its workspace and for some seconds, to find its "
               "zero.\n  Let it hang free, keep hands and hair away, and make sure that it is not "
               "held. If something is in its way, switch the device off.");
  require_no_stop();
  if (!is_agreed) {
    throw std::runtime_error(
        who +
        " has lost its zero and was not moved, because the movement was not confirmed. Open it "
        "again and confirm, or calibrate it with its manufacturer's program.");
  }
  // By the index, which the SDK documents to return the ID of a device that is already open.
  const int id = sdk.drdOpenID(identity.index);
  identity.is_robotic = id == identity.id;
  if (!identity.is_robotic) {
    if (id >= 0) sdk.drdClose(static_cast<char>(id));
    throw std::runtime_error("libdrd cannot open " + who + ": " + last_error_of(sdk) +
                             ". It was not moved; check that no other program uses it.");
  }
  require_no_stop();
  bool found = false;
  bool is_stopped = false;
  std::string words;
  {
    const OverdueStop overdue(stop, [&who, &tell] {
      if (!tell) return;
      tell("The SDK still moves " + who +
           " after a request to stop: switch the device off, and keep away from its handle.");
    });
    {
      const MovementEnder ender(sdk, identity.id, stop);
      found = sdk.drdAutoInit(identity.id) >= 0;
      if (!found) words = last_error_of(sdk);  // of the last call in this thread
    }
    is_stopped = stop.stop_requested();
    if (is_stopped) sdk.dhdStop(identity.id);
    require_let_go(sdk, identity.id, who, is_stopped);
  }
  if (is_stopped) {
    throw OpeningStopped(
        who +
        " was stopped on request while it moved to find its zero: its force is off, and its handle "
        "sinks slowly. Open it again to repeat the movement; confirmation is requested first.");
  }
  if (!found) {
    throw std::runtime_error(
        who + " did not find its zero: " + words +
        ". Clear its workspace, release the handle and open the device again.");
  }
}

}  // namespace asperity::force_dimension
