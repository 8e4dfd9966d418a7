#include "vnv/run/vtp_series.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "vnv/files/whole_file.hpp"

namespace touchstone::vnv {
namespace {

constexpr std::size_t block_bytes = 1 << 16;
constexpr int fast = 1;  // of zlib's levels; higher ones take three times as long and save little of doubles

/// Arrays in blocks that zlib compressed, each behind how many and how long they are, as 64-bit numbers.
class Appended {
 public:
  template <class Number>
  std::size_t add(const std::vector<Number>& numbers) {
    const std::size_t offset = bytes_.size(), size = numbers.size() * sizeof(Number),
                      blocks = (size + block_bytes - 1) / block_bytes;
    const auto* from = reinterpret_cast<const Bytef*>(numbers.data());
    std::vector<std::uint64_t> header = {blocks, block_bytes, size % block_bytes};
    std::string compressed;
    for (std::size_t at = 0; at < size; at += block_bytes) {
      uLong length = std::min(block_bytes, size - at);
      const std::size_t before = compressed.size();
      uLongf taken = compressBound(length);
      compressed.resize(before + taken);
      if (compress2(reinterpret_cast<Bytef*>(compressed.data() + before), &taken, from + at, length, fast) != Z_OK)
        throw std::runtime_error("zlib: cannot compress, expected enough memory");
      compressed.resize(before + taken);
      header.push_back(taken);
    }
    bytes_.append(reinterpret_cast<const char*>(header.data()), header.size() * sizeof(header[0]));
    bytes_ += compressed;
    return offset;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_{};
};

std::vector<double> three_components(const Vectors& plane) {
  std::vector<double> space(3 * static_cast<std::size_t>(plane.cols()));
  Eigen::Map<Eigen::Matrix3Xd>(space.data(), 3, plane.cols()).topRows<2>() = plane;
  return space;
}

std::vector<double> values_of(const Scalars& scalars) { return {scalars.begin(), scalars.end()}; }

std::vector<std::int64_t> numbers_from(std::int64_t first, Index count) {
  std::vector<std::int64_t> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

}  // namespace

void write_vtp(const std::filesystem::path& file, const Samples& samples) {
  static_assert(std::endian::native == std::endian::little, "the file says so");
  Appended appended;
  const auto array = [&](const char* name, const char* type, int components, const auto& numbers) {
    return fmt::format(
        "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n", type,
        name, components, appended.add(numbers));
  };
  const Index particles = samples.size();
  std::string text = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<PolyData>\n"
      "<FieldData><DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">{}</DataArray></FieldData>\n"
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n",
      samples.time, particles, particles);
  text += "<PointData Scalars=\"pressure\" Vectors=\"velocity\">\n" +
          array("velocity", "Float64", 3, three_components(samples.v)) +
          array("pressure", "Float64", 1, values_of(samples.pressure)) +
          array("density", "Float64", 1, values_of(samples.density)) +
          array("mass", "Float64", 1, values_of(samples.mass)) +
          array("particle number", "Int64", 1, numbers_from(0, particles)) + "</PointData>\n";
  text += "<Points>\n" + array("Points", "Float64", 3, three_components(samples.x)) + "</Points>\n";
  text += "<Verts>\n" + array("connectivity", "Int64", 1, numbers_from(0, particles)) +
          array("offsets", "Int64", 1, numbers_from(1, particles)) + "</Verts>\n";
  text += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  text += appended.bytes();
  text += "\n</AppendedData>\n</VTKFile>\n";
  files::write_whole(file, text);
}

void write_vtp_series(const std::filesystem::path& folder, const std::string& name, std::span<const Samples> series) {
  std::filesystem::create_directories(folder);
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n<Collection>\n";
  for (std::size_t i = 0; i < series.size(); ++i) {
    const std::string file = fmt::format("{}_{}.vtp", name, i);
    write_vtp(folder / file, series[i]);
    text += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", series[i].time, file);
  }
  files::write_whole(folder / (name + ".pvd"), text + "</Collection>\n</VTKFile>\n");
}

}  // namespace touchstone::vnv
