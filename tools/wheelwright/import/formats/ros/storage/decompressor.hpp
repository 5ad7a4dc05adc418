// Chunks and messages that were compressed. What a damaged or cut stream gives before its fault is given.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace wheelwright::import::ros {

enum class Compression { none, bz2, lz4, zstd };  // lz4: the frame format

// By the names that bags use ("none" and "" are none); nothing for another name.
std::optional<Compression> compression_named(std::string_view name);

// A larger chunk is not unpacked: the largest that recorders write hold one message of an image or of points.
inline constexpr std::uint64_t max_unpacked_bytes = 512U << 20U;

struct Unpacked {
  std::string_view bytes;  // valid until the next call
  std::string fault;       // why there are no more; empty where these are all
};

class Decompressor {
 public:
  // `announced` is the size after unpacking as the file has it. What is beyond it is left.
  Unpacked unpack(Compression compression, std::string_view packed, std::uint64_t announced);
  // Of a stream whose size is not known.
  Unpacked unpack(Compression compression, std::string_view packed);

 private:
  std::vector<char> buffer_;
};

bool is_zstd(std::string_view head);

}  // namespace wheelwright::import::ros
