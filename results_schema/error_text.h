// What an error is to the person who must act: what is wrong, where, what to do.

#pragma once

#include <exception>
#include <string>

namespace asperity {

/// True also where nothing was stored before.
inline constexpr const char* kDiskIsFull =
    "the disk is full; free space on the disk, then try again. Nothing that was stored before is "
    "lost";

/// What an error number of the operating system means and what to do, as the end of a sentence:
/// "Permission denied; check the permissions of the file and of its folder".
std::string text_of_error_number(int error_number);

/// The message of an error. The program's own errors state it themselves. What the standard library and the libraries of
/// formats throw through the program has words for programmers: too little memory, a file or a folder that the operating
/// system refuses, a thread or a process that it does not start, a text that is not the JSON that is expected.
std::string message_of(const std::exception& error);

}  // namespace asperity
