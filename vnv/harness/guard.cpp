/// A suite in which nothing ran, or everything was skipped, is no green suite. ctest calls this before and after one:
/// `touchstone_guard begin RECORDS` leaves a stamp and keeps the records of before aside, `touchstone_guard end
/// RECORDS` fails unless something was judged since.

#include "vnv/record/record.hpp"

#include <fmt/format.h>

#include <fstream>
#include <span>
#include <stdexcept>
#include <vector>

namespace {

namespace fs = std::filesystem;
using namespace touchstone::vnv;

void begin(const fs::path& records) {
  const fs::path before = records / "before";  // nobody judges these, of methods that may be gone
  fs::create_directories(before);
  std::vector<fs::path> old;
  for (const fs::directory_entry& entry : fs::directory_iterator(records))
    if (entry.path().extension() == ".json" || entry.path().extension() == ".part") old.push_back(entry.path());
  for (const fs::path& file : old)
    if (file.extension() == ".json")
      fs::rename(file, before / file.filename());
    else
      fs::remove(file);  // what a killed program was writing
  if (!old.empty()) fmt::print("{}: {} records of before\n", before.string(), old.size());
  fs::remove_all(records / "histories");
  if (!(std::ofstream(records / "stamp") << "suite began\n" << std::flush))
    throw std::runtime_error(fmt::format("{}: cannot be written, expected a folder for records", records.string()));
}

void end(const fs::path& records) {
  const auto began = fs::last_write_time(records / "stamp");
  long methods = 0, judged = 0, held = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(records)) {
    if (entry.path().extension() != ".json" || entry.last_write_time() < began) continue;
    const Record record = read_record(entry.path());
    ++methods;
    for (const Verdict& verdict : record.verdicts) {
      ++judged;
      held += verdict.outcome == Outcome::holds;
    }
  }
  if (judged == 0)
    throw std::runtime_error(fmt::format("{}: {} records and no verdict since the suite began, expected at least one",
                                         records.string(), methods));
  fmt::print("{} methods judged: {} of {} claims hold\n", methods, held, judged);
}

}  // namespace

int main(int count, char** arguments) {
  try {
    const std::span<char*> words(arguments, static_cast<std::size_t>(count));
    if (count == 3 && std::string_view(words[1]) == "begin") return begin(words[2]), EXIT_SUCCESS;
    if (count == 3 && std::string_view(words[1]) == "end") return end(words[2]), EXIT_SUCCESS;
    fmt::print(stderr, "usage: touchstone_guard begin|end RECORDS\n");
  } catch (const std::exception& error) {
    fmt::print(stderr, "touchstone_guard: {}\n", error.what());
  }
  return EXIT_FAILURE;
}
