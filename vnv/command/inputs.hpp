#pragma once
/// What a record was made from, so that finished work is known again: FOLDER/inputs/CASE.METHOD holds it, written after
/// the record FOLDER/CASE.METHOD.json.

#include "vnv/record/description.hpp"

#include <filesystem>
#include <string>

namespace touchstone::vnv::command {

/// A hash of bytes (FNV-1a, 64 bits), as hexadecimal digits: it distinguishes files, not forgeries.
class Hash {
 public:
  void add(std::string_view bytes);
  /// Throws std::runtime_error for a file that cannot be read.
  void add_file(const std::filesystem::path& file);
  std::string digits() const;

 private:
  unsigned long long value_ = 0xcbf29ce484222325;
};

/// Of the program of a case and all it may read: every file of data but the baselines and accepted claims of other
/// cases, which its own do not know.
std::string hash_of_inputs(const std::filesystem::path& program, const Description& described);

struct Inputs {
  std::string hash, suite;
};

/// Whether the folder has a record of CASE.METHOD that was made from these inputs.
bool is_done(const std::filesystem::path& records, const std::string& name, const Inputs& inputs);
/// Says so of the record that is there.
void set_done(const std::filesystem::path& records, const std::string& name, const Inputs& inputs);
/// Removes the record, what it was made from, and what a killed program left of it.
void forget(const std::filesystem::path& records, const std::string& name);

std::filesystem::path record_file(const std::filesystem::path& records, const std::string& name);

}  // namespace touchstone::vnv::command
