#include "vnv/programs/out_of_memory.hpp"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <string>

namespace touchstone::programs {
namespace {

std::string sentence;  // made while there is memory
int exit_status = 1;
std::terminate_handler terminate_otherwise = nullptr;

[[noreturn]] void terminate() {
  try {
    if (std::current_exception()) throw;
  } catch (const std::bad_alloc&) {
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, sentence.data(), sentence.size());
    _exit(exit_status);
  } catch (...) {
    // any other exception is an error of ours, of which a core tells more
  }
  terminate_otherwise();
  std::abort();
}

}  // namespace

void tell_when_out_of_memory(std::string_view program, int status) {
  sentence = std::string(program) + ": " + OutOfMemory().what() + "\n";
  exit_status = status;
  std::set_new_handler([] { throw OutOfMemory(); });
  terminate_otherwise = std::set_terminate(terminate);
}

}  // namespace touchstone::programs
