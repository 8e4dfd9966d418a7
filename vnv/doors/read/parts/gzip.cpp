#include "vnv/doors/read/parts/gzip.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <memory>

#include "vnv/doors/read/parts/numbers.hpp"

namespace touchstone::vnv::doors {

std::string gunzipped(const std::string& file, std::string_view bytes, const Limits& limits) {
  constexpr std::size_t each = 1 << 20;
  constexpr int gzip_only = 16 + MAX_WBITS;
  z_stream stream{};
  if (inflateInit2(&stream, gzip_only) != Z_OK) refuse(file, "zlib has no memory");
  const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&stream, inflateEnd);
  std::string text;
  int status = Z_OK;
  while (!bytes.empty()) {
    if (status == Z_STREAM_END) inflateReset(&stream);  // of several members
    const std::size_t taken = std::min<std::size_t>(bytes.size(), 1 << 30), before = text.size();
    text.resize(before + each);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));  // zlib only reads it
    stream.avail_in = static_cast<uInt>(taken);
    stream.next_out = reinterpret_cast<Bytef*>(text.data() + before);
    stream.avail_out = each;
    status = inflate(&stream, Z_NO_FLUSH);
    bytes.remove_prefix(taken - stream.avail_in);
    text.resize(before + each - stream.avail_out);
    if ((status != Z_OK && status != Z_STREAM_END) || text.size() > limits.most_bytes)
      refuse(file, fmt::format("not what gzip makes of {} bytes at the most, expected that", limits.most_bytes));
  }
  if (status != Z_STREAM_END) refuse(file, "ends within what gzip made, expected more of it");
  return text;
}

}  // namespace touchstone::vnv::doors
