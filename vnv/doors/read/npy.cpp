/// One array of numpy. Columns "column 1" and so on of a table of two dimensions, or one of one.

#include "vnv/doors/read/format.hpp"
#include "vnv/doors/read/parts/columns.hpp"
#include "vnv/doors/read/parts/numpy_array.hpp"

namespace touchstone::vnv::doors::formats {

Format npy() {
  return {.words = "NPY",
          .place = 20,
          .endings = {".npy"},
          .begins = numpy::npy_begins,
          .read = [](const std::filesystem::path& file, std::string_view bytes, const Limits& limits) {
            const numpy::NumpyArray array = numpy::npy_array(bytes, file.string());
            Budget budget(limits);
            std::vector<Block> blocks;
            blocks.push_back({"column 1", array.shape, numpy::numbers_of(array, budget, file.string())});
            return parted_by_time({.source = file.filename().string(),
                                   .format = "NPY",
                                   .index = number_of(file),
                                   .arrays = rows_of(std::move(blocks), file.string())});
          }};
}

}  // namespace touchstone::vnv::doors::formats
