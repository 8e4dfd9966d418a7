/// Series of VTK's files with their times: a collection (.pvd) or a list in JSON (.vtk.series, .vtm.series). Datasets
/// of all files, in the order of the times that the series gives; without a time there, that of the file stays. It
/// names files of its own folder only.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/files_beside.hpp"
#include "vnv/doors/read/parts/vtk_files.hpp"
#include "vnv/doors/read/parts/vtk_xml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace touchstone::vnv::doors::formats {
namespace {

namespace fs = std::filesystem;

struct Entry {
  std::string file;
  std::optional<double> time;
};

constexpr std::size_t deepest_of_series = 3;  // files, one of them, its name

std::vector<Entry> entries_of_json(const std::string& file, std::string_view bytes) {
  using Json = nlohmann::json;
  const auto is_shallow = [&](int depth, Json::parse_event_t, Json&) {
    if (std::cmp_greater(depth, deepest_of_series))
      refuse(file, fmt::format("JSON of more than {} levels, expected a series of files", deepest_of_series));
    return true;
  };
  Json json;
  try {
    json = Json::parse(bytes, is_shallow);
  } catch (const Json::parse_error& error) {
    refuse(fmt::format("{}: byte {}", file, error.byte), "expected JSON of a series of files");
  } catch (const Json::exception&) {  // a number that is none of a double
    refuse(file, "expected JSON of a series of files");
  }
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array())
    refuse(file, "no list 'files', expected one");
  std::vector<Entry> entries;
  for (const Json& entry : json["files"]) {
    const std::string where = fmt::format("{}: files[{}]", file, entries.size());
    if (!entry.is_object() || !entry.contains("name") || !entry["name"].is_string()) refuse(where, "expected a 'name'");
    if (entry.contains("time") && !entry["time"].is_number()) refuse(where, "'time' is no number, expected one");
    entries.push_back(
        {entry["name"], entry.contains("time") ? std::optional(entry["time"].get<double>()) : std::nullopt});
  }
  return entries;
}

std::vector<Entry> entries_of_collection(const std::string& file, std::string_view bytes, const Limits& limits) {
  const vtk::XmlFile xml(file, bytes, limits);
  if (xml.type() != "Collection") refuse(file, fmt::format("type '{:.40}', expected Collection", xml.type()));
  std::vector<Entry> entries;
  for (const pugi::xml_node& dataset : xml.root().child("Collection").children("DataSet")) {
    Entry entry{dataset.attribute("file").value(), std::nullopt};
    std::string_view time = dataset.attribute("timestep").value();
    std::vector<double> read;
    if (!next_word(time).empty())
      append_text(time = dataset.attribute("timestep").value(), 1, Type::float64,
                  fmt::format("{}: timestep of '{:.200}'", file, entry.file), read);
    if (!read.empty()) entry.time = read[0];
    entries.push_back(entry);
  }
  return entries;
}

/// What foamToVTK of OpenFOAM v1912 calls "_20" is cavity_20.vtk, beside cavity.vtk.series.
std::string full_name(const fs::path& series, const std::string& name) {
  if (!name.starts_with('_') || fs::exists(series.parent_path() / name)) return name;
  const fs::path first = series.stem();  // cavity.vtk
  return first.stem().string() + name + first.extension().string();
}

std::vector<Dataset> read_series(const fs::path& file, std::string_view bytes, const Limits& limits) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  const bool is_json = first != bytes.npos && bytes[first] == '{';
  const std::vector<Entry> entries =
      is_json ? entries_of_json(file.string(), bytes) : entries_of_collection(file.string(), bytes, limits);
  if (entries.size() > limits.most_datasets)
    refuse(file.string(), fmt::format("'{}' files, expected no more than {}", entries.size(), limits.most_datasets));
  FilesBeside files(file, limits);
  std::vector<Dataset> datasets;
  for (const Entry& entry : entries) {
    if (entry.time && !std::isfinite(*entry.time))
      refuse(file.string(), fmt::format("time '{}' of '{:.200}', expected a number", *entry.time, entry.file));
    const FilesBeside::Named named = files.read(file, full_name(file, entry.file));
    const bool is_legacy = named.bytes.starts_with(vtk::legacy_begins);
    for (Dataset& dataset : is_legacy ? vtk::read_legacy(named.file, named.bytes, limits)
                                      : vtk::read_xml(named.file, named.bytes, limits, files)) {
      dataset.source = fmt::format("{}: {}", file.filename().string(), dataset.source);
      if (entry.time) dataset.time = entry.time;
      if (!dataset.index) dataset.index = &entry - entries.data();
      datasets.push_back(std::move(dataset));
    }
  }
  const auto is_earlier = [](const Dataset& a, const Dataset& b) { return a.time < b.time; };  // without a time: first
  std::stable_sort(datasets.begin(), datasets.end(), is_earlier);
  return datasets;
}

}  // namespace

Format series() {
  return {.words = "PVD",
          .help = "PVD and series of them",
          .place = 12,
          .endings = {".pvd", ".series"},
          .is_it =
              [](const fs::path& file, std::string_view head) {
                return head.find("type=\"Collection\"") != head.npos || file.extension() == ".series";
              },
          .read = read_series};
}

}  // namespace touchstone::vnv::doors::formats
