/// Arrays of numpy, several in a zip file, and what PySPH writes in one. Arrays of equally many rows by their names,
/// those of one number left out, one of which may be the time; "x", "y" and others of one shape of two dimensions are
/// values on a grid, and a single such array is a table as of a .npy. Of PySPH's "particles" and "solver_data" the
/// particle arrays. Nothing is written, whatever the names within say.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/pickle.hpp"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

namespace touchstone::vnv::doors::formats {
namespace {

namespace fs = std::filesystem;
using numpy::npy_array, numpy::NumpyArray;

constexpr std::size_t most_entries = 10000;

/// Entries of a zip file in memory, one after the other.
class Zip {
 public:
  Zip(std::string_view bytes, std::string where, const Limits& limits)
      : where_(std::move(where)), left_(limits.most_bytes), unread_(bytes.size()) {
    zip_error_t error;
    zip_error_init(&error);
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
    zip_.reset(source ? zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error) : nullptr);
    const std::string why = zip_ ? "" : zip_error_strerror(&error);
    if (!zip_) zip_source_free(source);
    zip_error_fini(&error);
    if (!zip_) refuse(where_, fmt::format("{}, expected a zip file of numpy's arrays", why));
    if (entries() > most_entries)
      refuse(where_, fmt::format("'{}' entries, expected no more than {}", entries(), most_entries));
  }

  std::size_t entries() const { return static_cast<std::size_t>(zip_get_num_entries(zip_.get(), 0)); }

  /// Name without ".npy", and bytes.
  std::pair<std::string, std::string> read(std::size_t entry) {
    zip_stat_t is;
    if (zip_stat_index(zip_.get(), entry, 0, &is) != 0 || !is.name) refuse(where_, "an entry without a name");
    std::string name = is.name;
    const std::string where = fmt::format("{}: '{:.80}'", where_, name);
    if (name.ends_with(".npy")) name.resize(name.size() - 4);
    if (is.encryption_method != ZIP_EM_NONE || (is.comp_method != ZIP_CM_STORE && is.comp_method != ZIP_CM_DEFLATE))
      refuse(where, fmt::format("method '{}', expected stored or deflated, not encrypted", is.comp_method));
    if (is.comp_size > unread_ || is.size > left_ || is.size / most_that_deflate_saves > is.comp_size)
      refuse(where, fmt::format("'{}' bytes out of {}, expected no more than the file and its limit of memory allow",
                                is.size, is.comp_size));
    unread_ -= is.comp_size;
    left_ -= is.size;
    std::string bytes;
    bytes.reserve(is.size);
    expect_to_fill(bytes.data(), is.size);
    bytes.resize(is.size);
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> open(zip_fopen_index(zip_.get(), entry, 0), zip_fclose);
    const bool is_whole = open && zip_fread(open.get(), bytes.data(), bytes.size()) == std::ssize(bytes);
    char beyond;
    if (!is_whole || zip_fread(open.get(), &beyond, 1) != 0)  // the last of it compares the checksum
      refuse(where, fmt::format("{}, expected {} bytes",
                                open ? zip_file_strerror(open.get()) : zip_strerror(zip_.get()), is.size));
    return {std::move(name), std::move(bytes)};
  }

 private:
  std::string where_;
  std::unique_ptr<zip_t, void (*)(zip_t*)> zip_{nullptr, zip_discard};
  std::size_t left_, unread_;
};

/// The object that an array of objects with no dimension holds; `pickle` owns it.
const Pickle::Object* only_object(const Pickle& pickle) {
  const Pickle::Object& array = pickle.root();
  const bool is_one = array.items.size() == 1 && array.items[0]->items.size() == 1;
  return array.is == Pickle::Object::Is::array && is_one ? array.items[0]->items[0] : nullptr;
}

/// PySPH's Output of version 2: pysph/solver/output.py.
Dataset pysph_dataset(const std::map<std::string, std::string>& entries, const fs::path& file, Budget& budget) {
  const auto pickled = [&](const char* name) {
    const std::string where = fmt::format("{}: '{}.npy'", file.string(), name);
    const NumpyArray array = npy_array(entries.at(name), where);
    if (array.kind.letter != 'O') refuse(where, "no object, expected one of PySPH's output, version 2");
    return Pickle(array.bytes, where);
  };
  const Pickle particles = pickled("particles"), solver = pickled("solver_data");
  const Pickle::Object* all = only_object(particles);
  if (!all || all->is != Pickle::Object::Is::dictionary)
    refuse(file.string() + ": 'particles.npy'", "no dictionary, expected one of PySPH's output, version 2");
  std::vector<ParticleArray> read;
  for (std::size_t i = 0; i + 1 < all->items.size(); i += 2) {
    ParticleArray& one = read.emplace_back(ParticleArray{.name = std::string(all->items[i]->text), .arrays = {}});
    const std::string where = fmt::format("{}: particle array '{:.80}'", file.string(), one.name);
    const Pickle::Object* arrays = Pickle::value(all->items[i + 1], "arrays");
    if (!arrays) refuse(where, "no dictionary 'arrays', expected one");
    for (std::size_t k = 0; k + 1 < arrays->items.size(); k += 2) {
      const std::string name(arrays->items[k]->text);
      if (arrays->items[k + 1]->is != Pickle::Object::Is::array)
        refuse(where, fmt::format("property '{:.80}' is no array, expected one", name));
      one.arrays.push_back(
          {.name = name, .values = numpy::numbers_of(arrays->items[k + 1]->array, budget, where + ": " + name)});
    }
  }
  Dataset dataset{.format = "NPZ of PySPH", .arrays = rows_of(std::move(read), file.string())};
  const Pickle::Object* time = Pickle::value(only_object(solver), "t");
  if (time && time->is == Pickle::Object::Is::number && std::isfinite(time->number)) dataset.time = time->number;
  return dataset;
}

/// Numbers by their names; an entry is gone as soon as it is read.
Dataset plain_dataset(std::map<std::string, std::string> entries, const fs::path& file, Budget& budget) {
  Dataset dataset{.format = "NPZ"};
  std::vector<Block> blocks;
  for (auto& [name, held] : entries) {
    const std::string bytes = std::exchange(held, {}), where = fmt::format("{}: '{:.80}.npy'", file.string(), name);
    const NumpyArray array = npy_array(bytes, where);
    if (array.kind.letter == 'O')
      refuse(where, "objects of Python, expected numbers, or 'particles' and 'solver_data' of PySPH");
    if (!array.kind.is_number()) continue;  // texts are of no row
    if (numpy::size_of(array, where) != 1) {
      blocks.push_back({name, array.shape, numpy::numbers_of(array, budget, where)});
    } else if (names_time(name)) {
      const Type type = array.kind.letter == 'f' && array.kind.bytes == 4 ? Type::float32 : Type::float64;
      dataset.time = time_of(numpy::numbers_of({array.kind, {}, false, array.bytes}, budget, where)[0], type, where);
    }
  }
  dataset.arrays = rows_of(std::move(blocks), file.string());
  return dataset;
}

std::vector<Dataset> read_npz(const fs::path& file, std::string_view bytes, const Limits& limits) {
  Zip zip(bytes, file.string(), limits);
  std::map<std::string, std::string> entries;
  for (std::size_t i = 0; i < zip.entries(); ++i) {
    auto [name, of_it] = zip.read(i);
    if (!entries.emplace(name, std::move(of_it)).second)
      refuse(file.string(), fmt::format("array '{:.80}' twice, expected each name once", name));
  }
  Budget budget(limits);
  const bool is_pysph = entries.contains("particles") && entries.contains("solver_data");
  Dataset dataset = is_pysph ? pysph_dataset(entries, file, budget) : plain_dataset(std::move(entries), file, budget);
  dataset.source = file.filename().string();
  dataset.index = number_of(file);
  return parted_by_time(std::move(dataset));
}

}  // namespace

Format npz() {
  return {.words = "NPZ",
          .help = "NPZ and HDF5 (including those of PySPH)",
          .place = 21,
          .endings = {".npz"},
          .begins = "PK\x03\x04",
          .read = read_npz};
}

}  // namespace touchstone::vnv::doors::formats
