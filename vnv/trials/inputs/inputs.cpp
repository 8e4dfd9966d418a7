/// Each reader of what people and programs write, but for particle data, given any bytes: it takes them, or refuses
/// them in one line that names the file. `touchstone_inputs READER FILE...` does it with files, which must be taken,
/// and with mutations of them, which need not be; built by Clang as `fuzz_inputs READER FOLDER -runs=1000000`, it is
/// libFuzzer that mutates them.

#define main main_of_the_command  // its command line is a reader, too
#include "vnv/command/main.cpp"
#undef main

#include <sys/mman.h>
#include <unistd.h>

#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <typeinfo>

#include "reports/paper/references.hpp"
#include "reports/read/fault_trials.hpp"
#include "reports/read/known_failures.hpp"
#include "reports/read/night.hpp"
#include "vnv/command/patterns.hpp"
#include "vnv/command/settings.hpp"
#include "vnv/doors/solver.hpp"
#include "vnv/flows/formulas/flow_file.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/harness/options.hpp"
#include "vnv/judge/baselines.hpp"
#include "vnv/record/accepted_claims.hpp"
#include "vnv/record/record.hpp"

namespace touchstone::vnv {
namespace {

namespace fs = std::filesystem;

/// Throws std::logic_error, which no reader may: that is for this program.
void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error(what);
}

/// A file in memory with these bytes.
class InMemory {
 public:
  explicit InMemory(std::string_view bytes) : number_(memfd_create("input", MFD_CLOEXEC)) {
    require(number_ >= 0 && ::write(number_, bytes.data(), bytes.size()) == std::ssize(bytes), "no file in memory");
  }
  ~InMemory() { close(number_); }
  InMemory(const InMemory&) = delete;
  InMemory& operator=(const InMemory&) = delete;
  fs::path path() const { return fmt::format("/proc/self/fd/{}", number_); }

 private:
  int number_;
};

void take_table(const fs::path& file) {
  const Sheet sheet = read_sheet(file);
  DataTable(sheet, sheet.headings.cells);
}

/// Read again it is the same but for the sentences of verdicts that contradict it: these fail.
void take_record(const fs::path& file) {
  const auto again = [](const std::string& json) { return as_json(record_in(json, "again")); };
  const std::string once = again(as_json(read_record(file)));
  require(again(once) == once, "a record that was read and written is read otherwise");
}

/// Each line is an argument.
void take_arguments(const fs::path& file, const std::function<void(int, char**)>& parse) {
  std::vector<std::string> words{"program"};
  std::ifstream lines(file);
  for (std::string word; std::getline(lines, word);) words.push_back(word);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  parse(static_cast<int>(words.size()), arguments.data());
}

void take_case_options(const fs::path& file) {
  take_arguments(file, [](int count, char** arguments) { Options().parse("case", count, arguments); });
}

/// Nothing is done that it asks for.
void take_command(const fs::path& file) {
  take_arguments(file, [&](int count, char** arguments) {
    command::Session session;
    command::parse(session, count, arguments);
    const std::vector<std::string> words(arguments + 1, arguments + count);
    try {
      command::chosen_by(words, {"poiseuille.mpm", "dam_break.sph"});
    } catch (const std::invalid_argument&) {  // names a pattern, not this file
    }
    try {
      command::settings_of(words);
    } catch (const std::invalid_argument&) {
    }
  });
}

const std::map<std::string, void (*)(const fs::path&)> readers = {
    {"table", take_table},
    {"baselines", [](const fs::path& file) { read_baselines(file); }},
    {"claims", [](const fs::path& file) { read_accepted_claims(file); }},
    {"known_failures", [](const fs::path& file) { reports::read_known_failures(file); }},
    {"fault_trials", [](const fs::path& file) { reports::read_fault_trials(file); }},
    {"references", [](const fs::path& file) { reports::read_references(file); }},
    {"record", take_record},
    {"night", [](const fs::path& file) { reports::read_night(file); }},
    {"solver", [](const fs::path& file) { doors::read_solver(file); }},
    {"flow", [](const fs::path& file) { read_flow(file); }},
    {"case_options", take_case_options},
    {"command", take_command}};

using Reader = void (*)(const fs::path&);

Reader reader_named(const std::string& name) {
  const auto found = readers.find(name);
  require(found != readers.end(), fmt::format("no reader '{}'", name));
  return found->second;
}

/// The line in which a reader refuses a file; empty where it takes it.
std::string refusal(Reader read, std::string_view bytes) {
  const InMemory file(bytes);
  const std::string file_name = file.path();
  try {
    read(file.path());
    return "";
  } catch (const std::exception& error) {
    const std::string line = error.what();
    const bool is_meant = typeid(error) == typeid(std::runtime_error) || typeid(error) == typeid(BadData) ||
                          typeid(error) == typeid(std::invalid_argument);
    require(is_meant, fmt::format("{}: {}", typeid(error).name(), line));
    require(line.starts_with(file_name + ":"), "names no file: " + line);
    require(std::ranges::none_of(line, [](unsigned char c) { return c < ' ' || c == 127; }),
            "holds a control character: " + line);
    return line;
  }
}

}  // namespace
}  // namespace touchstone::vnv

#ifdef TOUCHSTONE_FUZZ

static touchstone::vnv::Reader fuzzed = nullptr;

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  if (*count < 2) return 1;
  fuzzed = touchstone::vnv::reader_named((*arguments)[1]);
  (*arguments)[1] = (*arguments)[0];
  ++*arguments;
  --*count;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  touchstone::vnv::refusal(fuzzed, {reinterpret_cast<const char*>(data), size});
  return 0;
}

#else

namespace touchstone::vnv {
namespace {

/// Lists in lists, as many as there are no frames on the stack.
std::string nested() { return std::string(200000, '[') + std::string(200000, ']'); }

/// A byte changed, an end too early, a part left out, a part twice, or as many brackets as no text means.
std::string mutated(std::string bytes, std::mt19937& random) {
  const auto place = [&] { return random() % (bytes.size() + 1); };
  const auto kind = random() % 16;
  if (kind == 0) return bytes.insert(place(), std::string(100000, "[{\"(,"[random() % 5]));
  if (kind < 3) return bytes.substr(0, place());
  if (kind < 6) return bytes.erase(place(), random() % 40);
  if (kind < 9) {
    const std::size_t from = place();
    return bytes.insert(place(), bytes.substr(from, random() % 40));
  }
  bytes.insert(place(), 1, static_cast<char>(random()));
  return random() % 2 ? bytes : bytes.erase(place(), 1);
}

int replay(const std::string& name, const std::vector<fs::path>& files) {
  constexpr int times = 200;  // of each file
  const Reader read = reader_named(name);
  std::mt19937 random(1);
  int taken = 0;
  for (const fs::path& file : files) {
    const std::string bytes = files::read_whole(file);
    const std::string why_not = refusal(read, bytes);
    require(why_not.empty(), fmt::format("{} is not taken: {}", file.string(), why_not));
    for (const std::size_t colon : {bytes.find(':'), bytes.rfind(':')})
      refusal(read, bytes.substr(0, colon + 1) + nested() + "}");
    for (int k = 0; k < times; ++k) taken += refusal(read, mutated(bytes, random)).empty();
  }
  std::cerr << fmt::format("{}: {} files and {} mutations, {} of which were taken\n", name, files.size(),
                           times * files.size(), taken);
  return files.empty() ? 1 : 0;
}

}  // namespace
}  // namespace touchstone::vnv

int main(int count, char** arguments) {
  try {
    touchstone::vnv::require(count > 1, "usage: touchstone_inputs READER FILE...");
    return touchstone::vnv::replay(arguments[1], {arguments + 2, arguments + count});
  } catch (const std::exception& error) {
    std::cerr << "touchstone_inputs: " << error.what() << '\n';
    return 1;
  }
}

#endif
