#include "vnv/command/inputs.hpp"

#include "vnv/files/whole_file.hpp"
#include "vnv/record/accepted_claims.hpp"

#include <fmt/format.h>

#include <fstream>
#include <set>
#include <stdexcept>
#include <vector>

namespace touchstone::vnv::command {
namespace {

namespace fs = std::filesystem;

fs::path inputs_file(const fs::path& records, const std::string& name) { return records / "inputs" / name; }

std::string text_of(const Inputs& inputs) { return fmt::format("suite {}\nhash {}\n", inputs.suite, inputs.hash); }

}  // namespace

void Hash::add(std::string_view bytes) {
  for (const char byte : bytes) value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
}

void Hash::add_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> part(1 << 16);
  while (in.read(part.data(), std::ssize(part)), in.gcount() > 0)
    add({part.data(), static_cast<std::size_t>(in.gcount())});
  if (!in.eof()) throw std::runtime_error(fmt::format("{}: cannot be read, expected a file to hash", file.string()));
}

std::string Hash::digits() const { return fmt::format("{:016x}", value_); }

std::string hash_of_inputs(const fs::path& program, const Description& described) {
  std::set<fs::path> files;  // in the order of their names
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(described.data_folder)) {
    const fs::path folder = entry.path().parent_path().filename();
    if (entry.is_regular_file() && folder != "baselines" && folder != "claims") files.insert(entry.path());
  }
  for (const fs::path& own : {fs::path(described.baseline_file), claims_file(described.data_folder, described.name)})
    if (fs::exists(own)) files.insert(own);
  Hash hash;
  hash.add_file(program);
  for (const fs::path& file : files) {
    hash.add(file.lexically_relative(described.data_folder).string() + '\0');
    hash.add_file(file);
  }
  return hash.digits();
}

fs::path record_file(const fs::path& records, const std::string& name) { return records / (name + ".json"); }

bool is_done(const fs::path& records, const std::string& name, const Inputs& inputs) {
  return fs::exists(record_file(records, name)) && files::read_whole(inputs_file(records, name)) == text_of(inputs);
}

void set_done(const fs::path& records, const std::string& name, const Inputs& inputs) {
  const fs::path file = inputs_file(records, name);
  fs::create_directories(file.parent_path());
  files::write_whole(file, text_of(inputs));
}

void forget(const fs::path& records, const std::string& name) {
  fs::remove(inputs_file(records, name));
  fs::remove(record_file(records, name));
  files::remove_what_the_killed_left(record_file(records, name));
}

}  // namespace touchstone::vnv::command
