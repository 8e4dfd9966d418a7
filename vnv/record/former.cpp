#include "vnv/record/former.hpp"

#include "vnv/files/data_folder.hpp"
#include "vnv/files/tables.hpp"
#include "vnv/record/quantity.hpp"

#include <map>
#include <nlohmann/json.hpp>

namespace touchstone::vnv {
namespace {

struct Renames {
  std::map<std::string, std::string> names, endings;
};

Renames read_renames() {
  const std::filesystem::path file = data_folder() / "renames.csv";
  if (!std::filesystem::exists(file)) return {};  // data of one who has no former records
  const Sheet sheet = read_sheet(file);
  require_headings(sheet, {"former", "current"});
  Renames renames;
  for (const Sheet::Row& row : sheet.rows)
    (row.cells[0].starts_with(", ") ? renames.endings : renames.names)[row.cells[0]] = row.cells[1];
  return renames;
}

std::string renamed(const Renames& renames, const std::string& name) {
  if (const auto found = renames.names.find(name); found != renames.names.end()) return found->second;
  for (const auto& [former, current] : renames.endings)
    if (name.ends_with(former)) return renamed(renames, name.substr(0, name.size() - former.size())) + current;
  return name;
}

}  // namespace

std::string current_name(const std::string& name) {
  static const Renames renames = read_renames();
  constexpr std::string_view order = "order of ";
  if (const std::size_t over = name.rfind(" over "); name.starts_with(order) && over != name.npos)
    return std::string(order) + current_name(name.substr(order.size(), over - order.size())) + name.substr(over);
  const Quantity quantity = with_heading(name);
  const std::string current = renamed(renames, quantity.name);
  return current + name.substr(quantity.name.size());
}

void rename_former_keys(nlohmann::ordered_json& json) {
  for (const auto& [former, current] : {std::pair("rung", "level"), std::pair("rungs", "levels")})
    if (json.is_object() && json.contains(former)) {
      json[current] = std::move(json[former]);
      json.erase(former);
    }
  if (!json.is_structured()) return;
  for (auto& item : json)
    if (item.is_structured() && !(item.is_array() && !item.empty() && item.front().is_number()))
      rename_former_keys(item);
}

}  // namespace touchstone::vnv
