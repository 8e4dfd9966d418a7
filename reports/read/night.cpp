#include "reports/read/night.hpp"

#include "reports/text/notation.hpp"
#include "vnv/files/whole_file.hpp"
#include "vnv/record/former.hpp"
#include "vnv/record/json.hpp"
#include "vnv/record/quantity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <tuple>

namespace touchstone::reports {

// Each kind of line is described once, for the writer and for the reader, so that the two cannot disagree.
TOUCHSTONE_FIELDS(Night, suite, revision, compiler, flags, machine, finished_at)
TOUCHSTONE_FIELDS_OF_A_CASE(NightRun, method, level, spacing, time_step, finished, outcome, cpu, wall, peak_memory,
                            particles, steps, particle_steps_per_second, machine)
TOUCHSTONE_FIELDS_OF_A_CASE(NightValue, method, level, spacing, time, quantity, value)
TOUCHSTONE_FIELDS_OF_A_CASE(NightOrder, method, ladder, quantity, time, levels, order, half_width)
TOUCHSTONE_FIELDS_OF_A_CASE(NightVerdict, method, level, spacing, time, quantity, author, value, lower, upper, margin,
                            outcome)

namespace {

namespace fs = std::filesystem;
using vnv::json::Json;
using vnv::json::Reader;
using vnv::json::Writer;

constexpr int schema = 1;

// Applies `visit` to each list of a night with the kind that opens its lines.
void for_each_list(auto& night, const auto& visit) {
  visit("run", night.runs);
  visit("error", night.errors);
  visit("limit", night.limits);
  visit("order", night.orders);
  visit("verdict", night.verdicts);
}

long lines_of(const Night& night) {
  std::size_t lines = 0;
  for_each_list(night, [&](const char*, const auto& list) { lines += list.size(); });
  return static_cast<long>(lines);
}

std::string line_of(const Writer& writer) { return writer.object().dump() + "\n"; }

std::string text_of(const Night& night) {
  Writer header;
  header("night", schema);
  header("lines", lines_of(night));
  describe(header, night);
  std::string text = line_of(header);
  for_each_list(night, [&](const char* kind, const auto& list) {
    for (const auto& item : list) {
      Writer writer;
      writer("kind", std::string(kind));
      describe(writer, item);
      text += line_of(writer);
    }
  });
  return text;
}

long read_header(const Json& json, Night& night) {
  if (!json.is_object() || !json.contains("night"))
    throw std::runtime_error("no night, expected a line with \"night\"");
  if (json["night"] != schema)
    throw std::runtime_error(
        fmt::format("night is {}, expected {}, the only schema known here", json["night"].dump(), schema));
  long lines = 0;
  const Reader reader(json);
  reader("lines", lines);
  describe(reader, night);
  return lines;
}

void read_line(Json json, Night& night) {
  std::string kind;
  const Reader reader(json);
  reader("kind", kind);
  if (kind == "run" && !json.contains("machine")) json["machine"] = night.machine;
  bool is_known = false;
  for_each_list(night, [&](const char* known, auto& list) {
    if (kind != known) return;
    is_known = true;
    auto& item = list.emplace_back();
    describe(reader, item);
    if constexpr (requires { item.quantity; }) item.quantity = vnv::current_name(item.quantity);
  });
  if (!is_known)
    throw std::runtime_error(fmt::format("kind is '{}', expected run, error, limit, order or verdict", kind));
}

Json parsed(const std::string& line) {
  Json json;
  try {
    json = vnv::json::parsed(line);
  } catch (const Json::parse_error&) {
  }
  if (!json.is_object()) throw std::runtime_error("not a complete JSON line");
  vnv::rename_former_keys(json);
  return json;
}

// A pure number has no "[-]", in errors as in verdicts.
std::string plain_quantity(const std::string& quantity) {
  const vnv::Quantity named = vnv::with_heading(quantity);
  return with_unit(named.name, named.unit);
}

NightRun summary(const vnv::Record& record, const vnv::RunSummary& run) {
  const vnv::Cost& c = run.cost;
  return {record.case_name,
          record.method,
          run.level,
          run.spacing,
          run.time_step,
          run.finished,
          run.outcome,
          c.cpu,
          c.wall,
          c.peak_memory,
          c.particles,
          c.steps,
          c.particle_steps_per_second(),
          record.machine};
}

// What a claim of convergence speaks of: the order above the floor, if there is one.
NightOrder summary(const vnv::Record& record, const vnv::ObservedOrder& o) {
  const bool above_floor = !std::isnan(o.floor);
  return {record.case_name,
          record.method,
          o.ladder,
          plain_quantity(o.quantity),
          o.time,
          static_cast<long>(o.errors.size()),
          above_floor ? o.order_to_floor : o.order,
          above_floor ? o.order_to_floor_half_width : o.half_width};
}

NightVerdict summary(const vnv::Verdict& v) {
  return {v.case_name, v.method, v.level, v.spacing, v.time,   with_unit(v.quantity, v.unit),
          v.author,    v.value,  v.lower, v.upper,   v.margin, v.outcome};
}

void add(const vnv::Record& record, Night& night) {
  for (const auto& run : record.runs) night.runs.push_back(summary(record, run));
  for (const auto& e : record.values)
    (e.quantity.kind == vnv::Kind::stability_limit ? night.limits : night.errors)
        .push_back({record.case_name, record.method, e.level, e.spacing, e.time, plain_quantity(e.quantity.heading()),
                    e.value});
  for (const auto& order : record.orders) night.orders.push_back(summary(record, order));
  for (const auto& verdict : record.verdicts) night.verdicts.push_back(summary(verdict));
}

std::vector<fs::path> night_files(const fs::path& folder) {
  std::error_code cause;
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder, cause))
    if (entry.path().extension() == ".jsonl") files.push_back(entry.path());
  if (cause) throw std::runtime_error(fmt::format("{}: cannot be read: {}", folder.string(), cause.message()));
  std::ranges::sort(files);
  return files;
}

}  // namespace

Night night_of(const std::vector<CaseRecords>& cases) {
  const auto circumstances = [](auto& of) {
    return std::tie(of.suite, of.revision, of.compiler, of.flags, of.machine, of.finished_at);
  };
  Night night;
  for (const auto& records : cases)
    for (const auto& record : records.records) {
      add(record, night);
      if (record.finished_at > night.finished_at) circumstances(night) = circumstances(record);
    }
  if (night.finished_at.empty())
    throw std::runtime_error("no record says when it finished, expected the date of a night");
  return night;
}

std::string file_name(const Night& night) {
  std::string name = night.finished_at + "_" + night.revision;
  std::erase(name, ':');
  const auto fits = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || std::strchr("._-", c); };
  std::ranges::replace_if(
      name, [&](char c) { return !fits(c); }, '-');
  return name + ".jsonl";
}

void write_night(const Night& night, const fs::path& folder) {
  std::error_code cause;
  fs::create_directories(folder, cause);
  if (cause) throw std::runtime_error(fmt::format("{}: cannot be written: {}", folder.string(), cause.message()));
  files::write_whole(folder / file_name(night), text_of(night));
}

Night read_night(const fs::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(errno)));
  Night night;
  long number = 0, expected = 0;
  const auto refuse = [&](const std::string& what) {
    throw vnv::BadData(file, static_cast<int>(std::max(number, 1L)), what);
  };
  try {
    for (std::string line; std::getline(stream, line);)
      if (++number == 1)
        expected = read_header(parsed(line), night);
      else
        read_line(parsed(line), night);
    if (number == 0) throw std::runtime_error("is empty, expected the header of a night");
    if (number != expected + 1)
      throw std::runtime_error(fmt::format("{} lines below the header, expected {}", number - 1, expected));
  } catch (const std::exception& error) {
    refuse(error.what());
  } catch (const vnv::json::Misfit& misfit) {
    refuse(misfit.sentence());
  }
  return night;
}

History read_history(const fs::path& folder, const std::string& suite) {
  History history;
  for (const auto& file : night_files(folder)) try {
      Night night = read_night(file);
      if (night.suite == suite) history.nights.push_back(std::move(night));
    } catch (const std::runtime_error& error) {
      history.refused.emplace_back(error.what());
    }
  std::ranges::stable_sort(history.nights, {}, &Night::finished_at);
  return history;
}

}  // namespace touchstone::reports
