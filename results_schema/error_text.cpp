// Errors of the operating system, the standard library and libraries, as sentences.

#include "results_schema/error_text.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <new>
#include <system_error>

#include <nlohmann/json.hpp>

namespace asperity {
namespace {

constexpr const char* kTooLittleMemory =
    "too little memory is free; close other programs, then try again";

std::string text_of_call(const std::system_error& error) {
  // What a thread or a process that does not begin is refused with.
  if (error.code() == std::errc::resource_unavailable_try_again) {
    return "the operating system does not start another thread or process; close other programs, "
           "or raise the limits of the user (ulimit -a), then try again";
  }
  if (error.code() == std::errc::not_enough_memory) return kTooLittleMemory;
  return error.what();
}

}  // namespace

std::string text_of_error_number(int error_number) {
  const std::string reason = std::strerror(error_number);
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return kDiskIsFull;
    case ENOMEM:
      return kTooLittleMemory;
    case EACCES:
    case EPERM:
      return reason + "; check the permissions of the file and of its folder";
    case ENOENT:
      return reason + "; check the path";
    case EISDIR:
      return reason + "; name a file, not a folder";
    case EEXIST:
      return reason + "; name another file, or remove this one";
    case EROFS:
      return reason + "; choose a folder that can be written to";
    case ELOOP:
      return reason + "; replace the link, which leads back to itself, with a file";
    case ENAMETOOLONG:
      return reason + "; choose a shorter name";
    case ENOTDIR:
      return reason + "; a part of the path is not a folder";
    case EMFILE:
    case ENFILE:
      return reason + "; close other programs, or raise the limit of open files (ulimit -n)";
    default:
      return reason + "; fix the problem, then try again";
  }
}

std::string message_of(const std::exception& error) {
  if (const auto* file = dynamic_cast<const std::filesystem::filesystem_error*>(&error)) {
    if (file->path1().empty())
      return "a folder cannot be read: " + text_of_error_number(file->code().value());
    return file->path1().string() + ": " + text_of_error_number(file->code().value());
  }
  if (const auto* call = dynamic_cast<const std::system_error*>(&error)) return text_of_call(*call);
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return kTooLittleMemory;
  if (dynamic_cast<const nlohmann::json::exception*>(&error) != nullptr) {
    return "a stored JSON text does not have the expected form; run asperity verify on the study";
  }
  return error.what();
}

}  // namespace asperity
