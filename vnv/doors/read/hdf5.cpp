/// Datasets of HDF5, by libhdf5. Numbers of equally many rows in the root or in the only group that has some; groups
/// "Step#1" and so on (H5Part), a time each; or the particle arrays of PySPH. A time is an attribute or a dataset of
/// one number, "t" or "time". Texts and records are passed over. Nothing outside the file is read: no links but those
/// to its own objects, no external or virtual datasets; of filters gzip and shuffle.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numbers.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <hdf5_hl.h>

#include <algorithm>

namespace touchstone::vnv::doors::formats {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_links = 10000;

/// Something of libhdf5 that is open for a while.
class Open {
 public:
  Open(hid_t id, herr_t (*close)(hid_t), const std::string& where) : id_(id), close_(close) {
    if (id < 0) refuse(where, "libhdf5 cannot open it, expected an object of HDF5 that is whole");
  }
  ~Open() { close_(id_); }
  Open(const Open&) = delete;
  Open& operator=(const Open&) = delete;
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Of a dataset or an attribute. Others than numbers are not read.
struct Extent {
  bool is_number = false, is_single = false;
  std::size_t bytes = 0;
  std::vector<std::size_t> shape{};

  Extent(hid_t type, hid_t space) {
    const H5T_class_t kind = H5Tget_class(type);
    bytes = H5Tget_size(type);
    is_number = (kind == H5T_INTEGER || kind == H5T_FLOAT) && bytes >= 1 && bytes <= 8 &&
                H5Sget_simple_extent_type(space) != H5S_NULL;
    is_single = kind == H5T_FLOAT && bytes == 4;
    const int rank = H5Sget_simple_extent_ndims(space);
    std::array<hsize_t, H5S_MAX_RANK> lengths{};
    if (rank < 0 || rank > H5S_MAX_RANK || H5Sget_simple_extent_dims(space, lengths.data(), nullptr) < 0)
      is_number = false;
    else
      shape.assign(lengths.begin(), lengths.begin() + rank);
  }
  bool is_one() const {
    return std::ranges::all_of(shape, [](std::size_t length) { return length == 1; });
  }
  bool is_empty() const { return std::ranges::find(shape, 0u) != shape.end(); }
};

class File {
 public:
  File(const fs::path& file, std::string_view bytes, const Limits& limits)
      : path_(file),
        name_(file.string()),
        size_(bytes.size()),
        budget_(limits),
        unread_(bytes.size()),
        file_(opened(bytes), H5Fclose, name_) {}

  std::vector<Dataset> datasets() {
    const Open root(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose, name_);
    const std::vector<std::string> groups = groups_of(root);
    const auto has = [&](const char* name) { return std::ranges::find(groups, name) != groups.end(); };
    std::vector<Dataset> all;
    if (has("particles") && has("solver_data")) {
      all.push_back(of_pysph(root));
      return all;
    }
    for (const std::string& name : groups)
      if (name.starts_with("Step#")) {
        all.push_back(of_group(root, name));
        all.back().format = "HDF5, H5Part";
        all.back().index = static_cast<long>(whole_number(std::string_view(name).substr(5), name_ + ": " + name));
      }
    std::ranges::sort(all, {}, &Dataset::index);
    if (!all.empty()) return all;
    std::optional<double> time = time_in(root);
    if (!time && has("Header")) {  // of Gadget and Swift
      const Open header(H5Gopen2(root, "Header", H5P_DEFAULT), H5Gclose, where("Header"));
      time = time_in(header);
    }
    const auto add = [&](Dataset one) {
      if (!one.time) one.time = time;
      if (!one.arrays.empty()) all.push_back(std::move(one));
    };
    add(of_group(root, "."));
    if (all.empty())
      for (const std::string& name : groups) add(of_group(root, name));
    if (all.size() != 1)
      refuse(name_, fmt::format("'{}' groups with arrays of numbers, expected one, Step#1 and so on of H5Part, or "
                                "particles and solver_data of PySPH",
                                all.size()));
    all[0].index = number_of(path_);
    return parted_by_time(std::move(all[0]));
  }

 private:
  hid_t opened(std::string_view bytes) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // what it would say on the terminal
    H5PLset_loading_state(0);                     // no filter but its own
    // It only reads what it neither copies nor releases.
    return H5LTopen_file_image(const_cast<char*>(bytes.data()), bytes.size(),
                               H5LT_FILE_IMAGE_DONT_COPY | H5LT_FILE_IMAGE_DONT_RELEASE);
  }

  /// Names that are links to objects of this file.
  std::vector<std::string> links_of(hid_t group) {
    std::vector<std::string> names;
    const auto add = [](hid_t, const char* name, const H5L_info_t* link, void* to) -> herr_t {
      auto& all = *static_cast<std::vector<std::string>*>(to);
      if (link->type == H5L_TYPE_HARD) all.emplace_back(name);
      return all.size() > most_links ? 1 : 0;
    };
    const herr_t status = H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, add, &names);
    if (status != 0) refuse(name_, fmt::format("a group that is broken, or of more than {} links", most_links));
    return names;
  }

  std::vector<std::string> of_kind(hid_t group, H5I_type_t kind) {
    std::vector<std::string> names = links_of(group);
    std::erase_if(names, [&](const std::string& name) {
      const Open object(H5Oopen(group, name.c_str(), H5P_DEFAULT), H5Oclose, where(name));
      return H5Iget_type(object) != kind;
    });
    return names;
  }
  std::vector<std::string> groups_of(hid_t group) { return of_kind(group, H5I_GROUP); }

  std::string where(const std::string& name) const { return fmt::format("{}: '{:.80}'", name_, name); }

  /// One that says so by its name.
  std::optional<double> time_in(hid_t group) {
    for (const char* name : {"t", "time", "Time", "TIME", "TimeValue"}) {
      if (H5Aexists(group, name) > 0) {
        const Open attribute(H5Aopen(group, name, H5P_DEFAULT), H5Aclose, where(name)),
            type(H5Aget_type(attribute), H5Tclose, where(name)), space(H5Aget_space(attribute), H5Sclose, where(name));
        const Extent is(type, space);
        double time = 0;
        if (!is.is_number || !is.is_one() || H5Aread(attribute, H5T_NATIVE_DOUBLE, &time) < 0)
          refuse(where(name), "an attribute that is no number, expected a time");
        return as_time(time, is, name);
      }
    }
    return {};
  }

  double as_time(double time, const Extent& is, const std::string& name) const {
    return time_of(time, is.is_single ? Type::float32 : Type::float64, where(name));
  }

  /// All numbers of a dataset, as large as what the file stores of it allows.
  std::vector<double> numbers_of(hid_t dataset, const Extent& is, const std::string& name) {
    if (is.shape.size() > 2) refuse(where(name), fmt::format("'{}' dimensions, expected 1 or 2", is.shape.size()));
    const Open created(H5Dget_create_plist(dataset), H5Pclose, where(name));
    const H5D_layout_t layout = H5Pget_layout(created);
    if ((layout != H5D_COMPACT && layout != H5D_CONTIGUOUS && layout != H5D_CHUNKED) ||
        H5Pget_external_count(created) != 0)
      refuse(where(name), "numbers that stand in another file, expected them in this one");
    for (int k = 0; k < H5Pget_nfilters(created); ++k) {
      unsigned flags = 0, configuration = 0;
      std::size_t count = 0;
      const H5Z_filter_t filter =
          H5Pget_filter2(created, static_cast<unsigned>(k), &flags, &count, nullptr, 0, nullptr, &configuration);
      if (filter != H5Z_FILTER_DEFLATE && filter != H5Z_FILTER_SHUFFLE)
        refuse(where(name), fmt::format("filter '{}', expected gzip (1) or shuffle (2)", static_cast<int>(filter)));
    }
    const std::size_t stored = H5Dget_storage_size(dataset);
    require_stored(is.shape, is.bytes, stored, name);
    if (layout == H5D_CHUNKED) {
      std::array<hsize_t, H5S_MAX_RANK> chunk{};
      const int rank = H5Pget_chunk(created, H5S_MAX_RANK, chunk.data());
      if (rank < 1) refuse(where(name), "chunks of no size, expected one");
      require_stored({chunk.begin(), chunk.begin() + rank}, is.bytes, stored, name);
    }
    unread_ -= stored;
    const std::size_t rows = is.shape.empty() ? 1 : is.shape[0], width = is.shape.size() < 2 ? 1 : is.shape[1];
    budget_.take(rows * width, 1, where(name));
    std::vector<double> numbers;
    reserve_more(numbers, rows * width);
    numbers.resize(rows * width);
    if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0)
      refuse(where(name), fmt::format("libhdf5 cannot read it, expected {} numbers", numbers.size()));
    return numbers;
  }

  /// So many numbers cannot be more than deflate makes of what is stored, nor that more than the file.
  void require_stored(const std::vector<std::size_t>& shape, std::size_t bytes, std::size_t stored,
                      const std::string& name) const {
    std::size_t left = std::min(stored, size_) * most_that_deflate_saves / bytes;
    std::string lengths;
    for (const std::size_t length : shape) {
      left /= std::max<std::size_t>(length, 1);
      lengths += fmt::format("{}{}", lengths.empty() ? "" : ", ", length);
    }
    if (left == 0 || stored > unread_)
      refuse(where(name),
             fmt::format("a shape ({}) out of {} bytes, expected no more than the file holds", lengths, stored));
  }

  /// Of all datasets in a group but those of no number; a time among them is that of all.
  struct Held {
    std::vector<Block> blocks{};
    std::optional<double> time{};
  };
  Held numbers_in(hid_t group) {
    Held held{.time = time_in(group)};
    for (const std::string& name : of_kind(group, H5I_DATASET)) {
      const Open dataset(H5Dopen2(group, name.c_str(), H5P_DEFAULT), H5Dclose, where(name)),
          type(H5Dget_type(dataset), H5Tclose, where(name)), space(H5Dget_space(dataset), H5Sclose, where(name));
      const Extent is(type, space);
      if (!is.is_number || is.is_empty() || (is.is_one() && !names_time(name))) continue;
      std::vector<double> numbers = numbers_of(dataset, is, name);
      if (is.is_one())
        held.time = as_time(numbers[0], is, name);
      else
        held.blocks.push_back({name, is.shape, std::move(numbers)});
    }
    return held;
  }

  Dataset of_group(hid_t parent, const std::string& name) {
    const Open group(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose, where(name));
    Held held = numbers_in(group);
    const std::string within = name == "." ? "" : ": " + name;
    Dataset one{.source = path_.filename().string() + within, .format = "HDF5", .time = held.time};
    if (!held.blocks.empty()) one.arrays = rows_of(std::move(held.blocks), name_ + within);
    return one;
  }

  /// pysph/solver/output.py: particles/NAME/arrays/PROPERTY, of which those that are not stored have no number.
  Dataset of_pysph(hid_t root) {
    const Open particles(H5Gopen2(root, "particles", H5P_DEFAULT), H5Gclose, where("particles")),
        solver(H5Gopen2(root, "solver_data", H5P_DEFAULT), H5Gclose, where("solver_data"));
    std::vector<ParticleArray> all;
    for (const std::string& name : groups_of(particles)) {
      const Open arrays(H5Gopen2(particles, (name + "/arrays").c_str(), H5P_DEFAULT), H5Gclose, where(name));
      ParticleArray& one = all.emplace_back(ParticleArray{.name = name, .arrays = {}});
      for (Block& block : numbers_in(arrays).blocks)
        one.arrays.push_back({.name = block.name, .values = std::move(block.values)});
    }
    return {.source = path_.filename().string(),
            .format = "HDF5 of PySPH",
            .time = time_in(solver),
            .index = number_of(path_),
            .arrays = rows_of(std::move(all), name_)};
  }

  const fs::path& path_;
  std::string name_;
  std::size_t size_;
  Budget budget_;
  std::size_t unread_;  // bytes of the file that no dataset has read yet
  Open file_;
};

}  // namespace

Format hdf5() {
  return {.words = "HDF5",
          .help = "NPZ and HDF5 (including those of PySPH)",
          .place = 30,
          .endings = {".h5", ".hdf5"},
          .begins = "\x89HDF\r\n\x1a\n",
          .read = [](const fs::path& file, std::string_view bytes,
                     const Limits& limits) { return File(file, bytes, limits).datasets(); },
          .may_crash = true};
}

}  // namespace touchstone::vnv::doors::formats
